#include <burnish/light/environment_layouts.h>

#include <algorithm>
#include <utility>

namespace burnish {
namespace {

/// Where a face lies, in faces from the left and the top.
struct Cell {
    int column, row;
};

/// A layout as columns x rows of faces and the cells of +X -X +Y -Y +Z -Z.
struct Grid {
    EnvironmentLayout layout;
    std::string_view name;
    int columns, rows;
    Cell cells[6];
};

constexpr Grid kGrids[] = {
    {EnvironmentLayout::vertical_strip, "vertical strip of cube faces", 1, 6, {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}},
    {EnvironmentLayout::horizontal_strip,
     "horizontal strip of cube faces",
     6,
     1,
     {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}},
    {EnvironmentLayout::two_rows, "two rows of cube faces", 3, 2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {2, 1}}},
    {EnvironmentLayout::horizontal_cross,
     "horizontal cross of cube faces",
     4,
     3,
     {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}}},
    {EnvironmentLayout::vertical_cross, "vertical cross of cube faces", 3, 4, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 3}, {1, 1}}},
};

const Grid* grid_of(EnvironmentLayout layout) {
    for (const Grid& grid : kGrids) {
        if (grid.layout == layout) return &grid;
    }
    return nullptr;
}

Image cut(const Image& picture, const Cell& cell, int size, bool turned) {
    Image face(size, size, picture.channels);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float* from = picture.at(cell.column * size + x, cell.row * size + y);
            std::copy_n(from, picture.channels, turned ? face.at(size - 1 - x, size - 1 - y) : face.at(x, y));
        }
    }
    return face;
}

}  // namespace

EnvironmentLayout layout_of(int width, int height) {
    for (const Grid& grid : kGrids) {
        const int size = width / grid.columns;
        if (size > 0 && size * grid.columns == width && size * grid.rows == height) return grid.layout;
    }
    return EnvironmentLayout::latlong;
}

std::string_view layout_name(EnvironmentLayout layout) {
    const Grid* grid = grid_of(layout);
    return grid ? grid->name : "lat-long";
}

bool faces_are_named(EnvironmentLayout layout) {
    return layout == EnvironmentLayout::vertical_strip || layout == EnvironmentLayout::horizontal_strip ||
           layout == EnvironmentLayout::two_rows;
}

std::array<Image, 6> cut_faces(const Image& picture, EnvironmentLayout layout) {
    const Grid& grid = *grid_of(layout);
    std::array<Image, 6> faces;
    for (int face = 0; face < 6; ++face) {
        const bool turned = layout == EnvironmentLayout::vertical_cross && face == 4;
        faces[face] = cut(picture, grid.cells[face], picture.width / grid.columns, turned);
    }
    return faces;
}

Image horizontal_cross(const std::array<Image, 6>& faces) {
    const Grid& grid = *grid_of(EnvironmentLayout::horizontal_cross);
    const int n = faces[0].width;
    Image cross(grid.columns * n, grid.rows * n, faces[0].channels);
    for (int face = 0; face < 6; ++face) {
        const Cell& cell = grid.cells[face];
        for (int y = 0; y < n; ++y) {
            const float* row = faces[face].at(0, y);
            std::copy_n(row, static_cast<size_t>(n) * faces[face].channels, cross.at(cell.column * n, cell.row * n + y));
        }
    }
    return cross;
}

std::array<Image, 6> from_z_up_names(std::array<Image, 6> faces) {
    auto& [px, nx, py, ny, pz, nz] = faces;
    return {std::move(px), std::move(nx), std::move(pz), std::move(nz), std::move(ny), std::move(py)};
}

}  // namespace burnish
