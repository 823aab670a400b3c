// All of burnish, in the order of its dataflow.
//
//     #include <burnish/burnish.h>
//     burnish::Job job;
//     job.aovs = "beauty.exr", job.environment = "studio.hdr", job.material = "chrome", job.output.file = "out.exr";
//     burnish::run(job, burnish::Progress());
#pragma once

#include <burnish/base/error.h>
#include <burnish/base/image.h>
#include <burnish/base/parallel.h>
#include <burnish/base/progress.h>
#include <burnish/base/types.h>

#include <burnish/input/assign.h>
#include <burnish/input/camera.h>
#include <burnish/input/color.h>
#include <burnish/input/exr_reader.h>
#include <burnish/input/frame.h>
#include <burnish/input/frames.h>
#include <burnish/input/roles.h>

#include <burnish/surface/screen_curvature.h>
#include <burnish/surface/surfaces.h>

#include <burnish/sampling/density.h>
#include <burnish/sampling/estimator.h>

#include <burnish/material/albedo.h>
#include <burnish/material/library.h>
#include <burnish/material/lobe.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/material/model.h>

#include <burnish/fit/fit.h>

#include <burnish/light/environment.h>
#include <burnish/light/light_chain.h>
#include <burnish/light/light_settings.h>

#include <burnish/frequency/bandwidth_buffer.h>
#include <burnish/frequency/light_bandwidth.h>
#include <burnish/frequency/lobe_bandwidth.h>
#include <burnish/frequency/local_bandwidth.h>
#include <burnish/frequency/operators.h>

#include <burnish/factor/factors.h>

#include <burnish/shading/dense.h>
#include <burnish/shading/sparse.h>

#include <burnish/composite/composite.h>

#include <burnish/output/compare.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/preview.h>
#include <burnish/output/report.h>

#include <burnish/plan/cost_model.h>
#include <burnish/plan/error_model.h>
#include <burnish/plan/truth.h>

#include <burnish/job/bake.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/job.h>
#include <burnish/job/look.h>
#include <burnish/job/read_frame.h>
#include <burnish/job/refinement.h>
#include <burnish/job/run.h>
#include <burnish/job/run_bandwidth.h>
#include <burnish/job/run_frame.h>
#include <burnish/job/run_progressive.h>
#include <burnish/job/settings.h>
#include <burnish/job/shot_file.h>
