// From what was shaded to what is composited: pixels as they are, or finer samples resolved to them.
#pragma once

#include <burnish/composite/composite.h>
#include <burnish/input/assign.h>
#include <burnish/job/job.h>
#include <burnish/job/run_frame.h>

namespace burnish {

/// Coverage only where a pixel was shaded: elsewhere there is no overlay that could take the rendered specular's place.
void cover_shaded(const Surfaces& surfaces, Assignment& assignment);

/// The cover of a frame that was shaded pixel by pixel. `kd`: per look. `assignment`'s coverage is used up.
Cover pixel_cover(const AovFrame& frame, const Surfaces& surfaces, Assignment& assignment,
                  const std::vector<DiffuseReflectance>& kd);

/// The filter that `frame` is taken to have been rendered with.
PixelFilter pixel_filter(const AntialiasSettings& settings, const AovFrame& frame);

/// What was shaded at the samples of `fine` as pixels of `frame`: `result` and `old` (empty images where nothing was) are
/// resolved in place. Throws Error(missing_channel) when coverage is to come from an alpha that is not there.
Cover resolve_samples(const AntialiasSettings& settings, const AovFrame& frame, const AovFrame& fine, const Surfaces& surfaces,
                      const Assignment& assignment, const std::vector<DiffuseReflectance>& kd, FrameResult& result,
                      ShadedFrame& old);

}  // namespace burnish
