// A job: everything one run needs to know, as plain values. Every face (command line, shot file, Python) fills this struct
// through the settings table (settings.h) and hands it to `run`.
//
// The initialisers here are the defaults of every face.
#pragma once

#include <burnish/composite/composite.h>
#include <burnish/composite/pixel_filter.h>
#include <burnish/input/assign.h>
#include <burnish/light/environment.h>
#include <burnish/light/light_settings.h>
#include <burnish/material/parameters.h>
#include <burnish/output/exr_writer.h>
#include <burnish/plan/quality_target.h>
#include <burnish/sampling/density.h>
#include <burnish/sampling/estimator.h>
#include <burnish/surface/surfaces.h>

#include <map>
#include <string>
#include <vector>

namespace burnish {

/// What a frame that is missing, unreadable or lacks a channel does to a sequence.
enum class BadFrames { error, skip };

/// How much of a pixel at an edge the overlay covers: by the samples that hit, or by the frame's alpha.
enum class EdgeCoverage { samples, alpha };

/// How finer AOVs become pixels.
struct AntialiasSettings {
    PixelFilter filter;
    EdgeCoverage coverage = EdgeCoverage::samples;
};

/// OpenColorIO names; an empty one means "as it is". The frame's own space must be linear: shading happens in it.
struct ColorSpaces {
    std::string config;  // OpenColorIO config file; "" = $OCIO
    std::string beauty, environment, output;
};

struct OutputSettings {
    std::string file;             // EXR, may hold a frame pattern
    std::string preview, report;  // PNG and JSON beside it; "" = none
    PixelType pixel_type = PixelType::half;
    bool diagnostics = false;  // validity, samples and error layers
    bool keep_layers = false;  // the frame's own parts behind burnish's
    bool skip_existing = false;
};

struct Job {
    std::string aovs;       // EXR, may hold a frame pattern
    std::string fine_aovs;  // the same at a multiple of its size: geometry and ids are taken from there; "" = none
    std::string frames;     // "1-24", "1-100x5"; "" = the file as named, or every frame found
    std::string view;       // multi-view files; kAllViews, or "" = the first
    BadFrames bad_frames = BadFrames::error;
    std::map<Role, std::string> channels;  // explicit layer per role
    std::string camera;                    // file, may hold a frame pattern, or the JSON itself; "" = from the frame

    std::string environment;  // file
    std::string environment_name = "sky";
    EnvironmentSettings light;
    std::map<std::string, LightSettings> lights;  // those near the objects, by name
    std::vector<std::string> chain;               // for rules that name no lights; empty: by place (assign_lights.h)

    std::string material;  // what pixels wear that no rule of `assign` names; "" = nothing
    std::map<std::string, Material> materials;
    std::vector<AssignRule> assign;
    std::map<std::string, std::string> old_materials;  // mode difference: material of the render, by today's name
    PerPixel per_pixel;                                // applied to every lobe

    QualityTarget target;  // set: it decides on estimator and density, whose settings count for nothing but where they forbid
    EstimatorSettings estimator;
    std::map<std::string, std::string> factors;  // estimator factored: file of the maps, by material
    DensitySettings density;
    SurfaceSettings surface;
    CompositeSettings composite;
    AntialiasSettings antialias;
    ColorSpaces color;
    OutputSettings output;
    int threads = 0;  // 0 = all cores
};

}  // namespace burnish
