// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTextureSupport_h
#define vpTextureSupport_h

#include <visp3/cues/vpEdgeCue.h>

BEGIN_VISP_NAMESPACE

/*!
  Learns from trusted frames which edges of the model's texture the images show. What is printed may be worn, covered,
  too dark, or lost among finer print: an edge of which too few points are found, over enough of them that were looked
  for, is left out.
*/
class vpTextureSupport
{
public:
  //! \param weights Robust weights of the rows that \e matches gave. \param view That was matched.
  //! \param options Its textureEdgesLeftOut are brought up to date.
  void update(const std::vector<vpEdgeCue::Match> &matches, const std::vector<double> &weights, const vpModelView &view,
              vpModelViewOptions &options);
  //! Uses all edges again.
  void reset(vpModelViewOptions &options);

private:
  // Control points of one edge.
  struct Count
  {
    double searched = 0.;
    double found = 0.; // And not refused by the robust estimation.
  };

  std::vector<Count> m_counts;
};

END_VISP_NAMESPACE
#endif
