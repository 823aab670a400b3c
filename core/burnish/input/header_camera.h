// The camera in a file's header. Headers disagree about what a camera matrix is, so where there is a position layer every
// reading of the matrix is tried against it, and only one that reprojects is taken.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/camera.h>
#include <burnish/input/row_strips.h>

#include <optional>
#include <string>

namespace burnish {

struct Metadata;

/// What headers say about the camera, as stored.
///
/// `matrix` is worldToCamera by the OpenEXR standard (row vectors, left-handed camera space, +Z forward; Arnold, RenderMan,
/// Karma), but also right-handed with -Z forward (Clarisse) or the very inverse (V-Ray's cameraTransform, which OpenImageIO
/// renames and oiiotool writes back under the standard name). worldToNDC is never read: its range and signs are anyone's guess.
struct CameraHeader {
    std::optional<Matrix44f> matrix;
    bool vray = false;                // by the file's other attributes
    std::optional<double> fov_x_deg;  // full horizontal angle; from focal length and aperture when only those are there
};

CameraHeader camera_header(const Metadata& metadata);

/// The header's camera.
///
/// position      the frame's position layer or null. With it, a reading of the matrix is taken when it sends the median
///               pixel to within half a pixel of its place; the layer then also gives the angle of view and the lens shift.
///               Without it, or with fewer than 50 pixels to check, the likeliest reading is taken
///               on trust, and the note says so ("not checked").
/// valid         1 channel, > 0 where position holds; may be null
/// rows          which of the frame the layers hold
/// pixel_aspect  width over height of a pixel
/// note          what was found, or why the header's camera was not taken; empty when the header has none
std::optional<Camera> header_camera(const CameraHeader& header, const Image* position, const Image* valid,
                                    const RowStrips& rows, const Window& display, float pixel_aspect, std::string& note);

}  // namespace burnish
