// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelSymmetriesReader_h
#define vpModelSymmetriesReader_h

#include <visp3/model/vpModelSymmetries.h>

#include <string>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue_settings
  Reads the symmetries of objects from the file models_info.json of a data set in BOP's layout.

  The file is a JSON object with one member for each object, named by its number. Of its keys two are read, all others
  are passed over: symmetries_discrete, a list of lists of 16 numbers, the rows of a matrix that brings the object to
  where it looks the same; and symmetries_continuous, a list of objects with axis, three numbers, and offset, three
  numbers, a point of the axis. Translations and offsets are in millimetres there, and metres in what is returned.
*/
class VISP_EXPORT vpModelSymmetriesReader
{
public:
  /*!
    \param file Path of models_info.json. \param object The object's number; 0 for the only one of the file.
    \return None where the file declares none for the object.
    \throw vpException naming the file, and the object and key where they are known, where the file is missing or no
    JSON, has no such object, or has a value that is no symmetry.
  */
  static vpModelSymmetries read(const std::string &file, unsigned int object = 0);
};

END_VISP_NAMESPACE
#endif
