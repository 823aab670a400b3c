// numpy arrays <-> burnish images and vectors. Arrays are (height, width, channels) or (n, 3), float32, C-contiguous.
#pragma once

#include <burnish/base/error.h>
#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace burnish::python {

namespace py = pybind11;
/// Any real array; converted and copied when it is not float32 and C-contiguous.
using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Image from (height, width) or (height, width, channels); `name` is for messages. Throws Error(size_mismatch).
inline Image to_image(const FloatArray& array, const std::string& name) {
    constexpr py::ssize_t kLargest = 1 << 20;  // pixels of an edge
    const bool plane = array.ndim() == 2;
    if ((!plane && array.ndim() != 3) || array.size() == 0 || array.shape(0) > kLargest || array.shape(1) > kLargest)
        throw Error(ErrorCode::size_mismatch, name + ": expected an array of shape (height, width, channels)");
    Image image;
    image.height = static_cast<int>(array.shape(0)), image.width = static_cast<int>(array.shape(1));
    image.channels = plane ? 1 : static_cast<int>(array.shape(2));
    image.data.assign(array.data(), array.data() + array.size());
    return image;
}

inline Image to_image(py::handle object, const std::string& name) {
    const FloatArray array = FloatArray::ensure(object);
    if (!array) throw Error(ErrorCode::bad_argument, name + ": expected an array of numbers");
    return to_image(array, name);
}

/// Array that owns the image's pixels: (height, width) for one channel, else (height, width, channels).
inline FloatArray to_array(Image&& image) {
    auto* owner = new Image(std::move(image));
    const py::capsule free(owner, [](void* held) { delete static_cast<Image*>(held); });
    std::vector<py::ssize_t> shape{owner->height, owner->width};
    if (owner->channels > 1) shape.push_back(owner->channels);
    return FloatArray(shape, owner->data.data(), free);
}

/// Rows of an (n, `columns`) array. Throws Error(size_mismatch).
inline py::ssize_t rows(const FloatArray& array, py::ssize_t columns, const std::string& name) {
    if (array.ndim() != 2 || array.shape(1) != columns)
        throw Error(ErrorCode::size_mismatch, name + ": expected an array of shape (n, " + std::to_string(columns) + ")");
    return array.shape(0);
}

/// Rows that two arrays share. Throws Error(size_mismatch).
inline py::ssize_t same_rows(py::ssize_t a, py::ssize_t b, const std::string& names) {
    if (a != b)
        throw Error(ErrorCode::size_mismatch,
                    names + ": expected as many rows, found " + std::to_string(a) + " and " + std::to_string(b));
    return a;
}

inline Vec3f vec3(const FloatArray& array, py::ssize_t row) { return {array.at(row, 0), array.at(row, 1), array.at(row, 2)}; }

/// (n, 3) array whose row i is make(i).
template <class Make>
FloatArray triples(py::ssize_t count, Make&& make) {
    FloatArray out(std::vector<py::ssize_t>{count, 3});
    float* to = out.mutable_data();
    for (py::ssize_t i = 0; i < count; ++i, to += 3) {
        const auto v = make(i);
        to[0] = v.x, to[1] = v.y, to[2] = v.z;
    }
    return out;
}

/// (n,) array whose entry i is make(i).
template <class Make>
FloatArray scalars(py::ssize_t count, Make&& make) {
    FloatArray out(count);
    float* to = out.mutable_data();
    for (py::ssize_t i = 0; i < count; ++i) to[i] = make(i);
    return out;
}

}  // namespace burnish::python
