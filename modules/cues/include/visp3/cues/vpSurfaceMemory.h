// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfaceMemory_h
#define vpSurfaceMemory_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/cues/vpCueFrame.h>
#include <visp3/model/vpSurfaceSamples.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

class vpPlaceProjection;
struct vpRenderedView;
struct vpSeenPlace;

/*!
  \ingroup group_cues_memory
  What the object's surface looked like in trusted frames, at some hundred places on it; tells a pose from others of the
  same outline, such as those of a box that is turned by half a turn.

  The places are put into patches. A pose is judged by the mean over the patches in view of the correlation between the
  colours that are remembered and those that the image shows where the pose has them; patches of one colour have no part
  in it. Patches tell the object from what hides a part of it, and their brightness is compared about its mean, since
  the light on a face changes when it turns. Images are read at half resolution. See \ref cues_memory.

  One memory serves one thread at a time, but for agreement(): many may ask while nothing else is called.
*/
class VISP_EXPORT vpSurfaceMemory
{
public:
  //! How a pose agrees with the memory.
  struct Agreement
  {
    double correlation = 0.; //!< [-1, 1], about 1 where they agree; 0 where nothing that is remembered is in view.
    double known = 0.;       //!< Share of the places in view whose patches are remembered, [0, 1].
    double texture = 0.;     //!< How much these tell, [0, 1]: 0 for a surface of one colour.
  };

  //! What is remembered.
  struct Reference
  {
    std::vector<float> weights;               //!< Of each place: 0 where it was never seen, rising to 1.
    std::vector<std::array<float, 4>> colors; //!< Gray levels.
    std::vector<std::array<float, 4>> shades; //!< The same as patches are compared by.
    std::array<float, 4> middle{};            //!< Mean of the shades.
    double texture = 0.;                      //!< See texture().
    unsigned int channels = 3;                //!< Of the images: 1 or 3.
  };

  //! Forgets everything. \param samples Places on the surface, see vpSampleSurface().
  void setSamples(const std::vector<vpSurfaceSample> &samples);
  //! Forgets the colours.
  void reset();
  //! How much all that is remembered tells poses apart, [0, 1]: 0 for a surface of one colour, and before learn().
  double texture() const { return m_known.texture; }

  /*!
    Takes the image that agreement() and learn() look at. A frame of another kind, gray instead of colour or the other
    way round, makes it forget the colours. Memory is used again: where the last frame was as large, nothing is
    allocated.
    \param frame Has to live no longer than this call; the one of the last call costs nothing.
  */
  void setFrame(const vpCueFrame &frame);
  //! \param cMo Any pose, one behind the camera included: nothing is in view there. \pre setFrame()
  Agreement agreement(const vpHomogeneousMatrix &cMo) const { return agreement(cMo, m_known); }
  //! The same with what was remembered another time. \return Nothing in view where that is of other places, or of gray
  //! images and the last one had colour, or the other way round.
  Agreement agreement(const vpHomogeneousMatrix &cMo, const Reference &reference) const;
  /*!
    Mixes what the image shows into what is remembered, 15 % of it. A patch that contradicts the memory is not learnt,
    as something may be in front of the object; after some 35 frames of that it is forgotten. \param cMo A trusted pose.
    \param depth Of the model at a pose near \e cMo in the whole image, so that what the object hides itself is not
    learnt; null for a convex one.
    \pre setFrame()
  */
  void learn(const vpHomogeneousMatrix &cMo, const vpRenderedView *depth);

  const Reference &reference() const { return m_known; }
  //! Goes back to what was known before. Nothing happens where that was told of other places, or by gray images and the
  //! last one had colour, or the other way round.
  void setReference(const Reference &reference);

private:
  static constexpr std::size_t patches = 48;

  template <typename Sums, typename Visible>
  void sumUp(vpPlaceProjection &projection, const Reference &known, Sums &sums, Visible isVisible) const;
  void mix(const vpSeenPlace &place);
  void summarise();

  // In arrays for loops over all places: position, normal, and whether a place is seen from both sides.
  std::vector<float> m_places;
  std::vector<std::uint8_t> m_patches; // Of each place.
  Reference m_known;
  std::vector<std::uint8_t> m_pixels; // Four bytes each.
  int m_width = 0;
  int m_height = 0;
  vpCameraParameters m_camera; // Of the full image.
  unsigned long long m_frame = 0;
};

END_VISP_NAMESPACE
#endif
