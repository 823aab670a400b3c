#include <burnish/light/filter/cube_filter.h>

#include <burnish/base/parallel.h>

#include <cstdlib>

namespace burnish {
namespace {

constexpr double kBalanceTolerance = 1e-4;  // relative error of a texel's share
constexpr double kOverRelaxation = 1.4;     // measured: 1 or 2 steps for faces of 512, 3 to 5 for 128
constexpr int kMaxBalanceSteps = 100;
constexpr int kBandRows = 16;  // coarse rows one task makes

std::vector<double> kernel_taps(PyramidKernel kernel) {
    switch (kernel) {
        case PyramidKernel::box2: return {1 / 2.0, 1 / 2.0};
        case PyramidKernel::binomial4: return {1 / 8.0, 3 / 8.0, 3 / 8.0, 1 / 8.0};
        case PyramidKernel::binomial6: break;
    }
    return {1 / 32.0, 5 / 32.0, 10 / 32.0, 10 / 32.0, 5 / 32.0, 1 / 32.0};
}

/// ln(a / sqrt(Omega_c)) on large faces, as factors of r^2, r^4, Re z^4 and r^2 Re z^4, z = u + iv, r = |z|: a fit to converged
/// solutions, good to 2e-3. It is a slow diffusion's end, driven by the kink of Omega at the edges.
std::array<double, 4> kernel_drift(PyramidKernel kernel) {
    switch (kernel) {
        case PyramidKernel::box2: return {0, 0, 0, 0};
        case PyramidKernel::binomial4: return {0.2251, -0.0545, 0.0086, -0.0100};
        case PyramidKernel::binomial6: break;
    }
    return {0.1357, -0.0336, 0.0050, -0.0061};
}

/// A symmetric field continues as its mirror image, beyond the face's edge because the neighbouring face holds the same
/// field, and beyond the face's middle lines.
int mirrored(int i, int size) { return i < 0 ? -1 - i : (i < size ? i : 2 * size - 1 - i); }

/// Of a face with `face_size` texels a side.
FaceField solid_angles(int face_size) {
    const int n = face_size / 2;
    FaceField omega{n, std::vector<double>(static_cast<size_t>(n) * n)};
    const auto corner = [&](int x, int y) {  // of what lies between it and the face's middle
        return cube_solid_angle(2.0 * x / face_size - 1.0, 0.0, 2.0 * y / face_size - 1.0, 0.0);
    };
    for_each_index(n, [&](int y) {
        double left = corner(0, y) - corner(0, y + 1);
        for (int x = 0; x < n; ++x) {
            const double right = corner(x + 1, y) - corner(x + 1, y + 1);
            omega.values[static_cast<size_t>(y) * n + x] = left - right;
            left = right;
        }
    });
    return omega;
}

FaceField summed_by_four(const FaceField& fine) {
    const int n = fine.size / 2;
    FaceField coarse{n, std::vector<double>(static_cast<size_t>(n) * n)};
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double* top = &fine.values[static_cast<size_t>(2 * y) * fine.size + 2 * x];
            coarse.values[static_cast<size_t>(y) * n + x] = (top[0] + top[1]) + (top[fine.size] + top[fine.size + 1]);
        }
    }
    return coarse;
}

/// `rows` x `columns` values to their transpose: lets one loop over rows serve both directions.
std::vector<double> transposed(const std::vector<double>& in, int rows, int columns) {
    std::vector<double> out(in.size());
    constexpr int block = 16;
    for_each_index((columns + block - 1) / block, [&](int strip) {
        const int end = std::min(columns, (strip + 1) * block);
        for (int y = 0; y < rows; ++y) {
            for (int x = strip * block; x < end; ++x)
                out[static_cast<size_t>(x) * rows + y] = in[static_cast<size_t>(y) * columns + x];
        }
    });
    return out;
}

/// out[row] = sum over (source row, weight) of `sources(row)`, rows of `columns` values.
template <class Sources>
std::vector<double> combined_rows(const std::vector<double>& in, int rows, int columns, Sources&& sources) {
    std::vector<double> out(static_cast<size_t>(rows) * columns);
    for_each_index(rows, [&](int row) {
        double* target = &out[static_cast<size_t>(row) * columns];
        sources(row, [&](int source_row, double weight) {
            const double* source = &in[static_cast<size_t>(source_row) * columns];
            for (int x = 0; x < columns; ++x) target[x] += weight * source[x];
        });
    });
    return out;
}

/// sum_i k_ci f_i: a fine field gathered to the coarse texels.
FaceField gathered(const FaceField& fine, const std::vector<double>& taps) {
    const int n = fine.size, half = n / 2, count = static_cast<int>(taps.size()), reach = (count - 2) / 2;
    const auto sources = [&](int row, auto&& add) {
        for (int t = 0; t < count; ++t) add(mirrored(2 * row + t - reach, n), taps[t]);
    };
    const std::vector<double> down = combined_rows(fine.values, half, n, sources);
    return {half, combined_rows(transposed(down, half, n), half, half, sources)};
}

/// sum_c k_ci f_c: a coarse field spread to the fine texels, the adjoint of `gathered`.
FaceField spread(const FaceField& coarse, const std::vector<double>& taps) {
    const int half = coarse.size, n = 2 * half, count = static_cast<int>(taps.size()), reach = (count - 2) / 2;
    const auto sources = [&](int row, auto&& add) {
        for (int t = (row + reach) % 2; t < count; t += 2) add(mirrored((row + reach - t) / 2, half), taps[t]);
    };
    const std::vector<double> down = combined_rows(coarse.values, n, half, sources);
    return {n, combined_rows(transposed(down, n, half), n, n, sources)};
}

FaceField quotient(const FaceField& over, const FaceField& under) {
    FaceField result = over;
    for (size_t i = 0; i < result.values.size(); ++i) result.values[i] /= under.values[i];
    return result;
}

/// Moves a factor past share / sum, its new value (successive over-relaxation); returns the largest relative step.
double relax(FaceField& factor, const FaceField& share, const FaceField& sum) {
    const int n = factor.size;
    std::vector<double> worst(n);
    for_each_index(n, [&](int y) {
        const size_t row = static_cast<size_t>(y) * n;
        double most = 0.0;
        for (int x = 0; x < n; ++x) {
            double& value = factor.values[row + x];
            const double step = share.values[row + x] / (sum.values[row + x] * value) - 1.0;
            most = std::max(most, std::fabs(step));
            value *= 1.0 + kOverRelaxation * step;
        }
        worst[y] = most;
    });
    return *std::max_element(worst.begin(), worst.end());
}

/// A quarter's values for the whole face.
std::vector<float> whole_face(const FaceField& quarter) {
    const int n = quarter.size;
    std::vector<float> face(static_cast<size_t>(4 * n) * n);
    for_each_index(2 * n, [&](int y) {
        for (int x = 0; x < 2 * n; ++x) {
            const double value = quarter.values[static_cast<size_t>(mirrored(y, n)) * n + mirrored(x, n)];
            face[static_cast<size_t>(y) * 2 * n + x] = static_cast<float>(value);
        }
    });
    return face;
}

/// Rows of one face reduced to half their width; rows and columns beyond the face come from its neighbours.
class RowReducer {
public:
    RowReducer(const CubeLevel& fine, const std::vector<float>& weights, const std::vector<double>& taps)
        : m_fine(fine),
          m_weights(weights),
          m_taps(taps.begin(), taps.end()),
          m_reach((static_cast<int>(taps.size()) - 2) / 2),
          m_row(4 * static_cast<size_t>(fine.size() + 2 * m_reach)) {}

    int reach() const { return m_reach; }
    const std::vector<float>& taps() const { return m_taps; }

    /// Row y in [-reach, size + reach), weighted, to size / 2 RGBA texels.
    void reduce(int face, int y, float* out) {
        const int n = m_fine.size();
        const bool inside = y >= 0 && y < n;
        for (int x = -m_reach; x < n + m_reach; ++x) {
            if (inside && x >= 0 && x < n)
                put(x, {face, x, y}, 1.0f);
            else
                put_beyond(face, x, y);
        }
        for (int c = 0; c < n / 2; ++c) {
            float sum[4] = {0, 0, 0, 0};
            const float* in = &m_row[8 * static_cast<size_t>(c)];
            for (size_t t = 0; t < m_taps.size(); ++t) {
                for (int k = 0; k < 4; ++k) sum[k] += m_taps[t] * in[4 * t + k];
            }
            std::copy_n(sum, 4, out + 4 * static_cast<size_t>(c));
        }
    }

private:
    /// Three faces meet where four would be needed: the missing quadrant is the mean of the two neighbours' corners, which
    /// gives each texel back the share that the missing coarse texels would have taken.
    void put_beyond(int face, int x, int y) {
        const int n = m_fine.size(), inner_x = mirrored(x, n), inner_y = mirrored(y, n);
        const CubeTexel across_x = unfolded_texel(face, x, inner_y, n), across_y = unfolded_texel(face, inner_x, y, n);
        put(x, x != inner_x ? across_x : across_y, 1.0f);
        if (x == inner_x || y == inner_y) return;
        put(x, across_x, 0.5f);
        add(x, across_y, 0.5f);
    }

    void put(int x, const CubeTexel& t, float share) {
        std::fill_n(slot(x), 4, 0.0f);
        add(x, t, share);
    }
    void add(int x, const CubeTexel& t, float share) {
        const float* rgba = m_fine.at(t.face, t.x, t.y);
        const float weight = share * m_weights[static_cast<size_t>(t.y) * m_fine.size() + t.x];
        for (int k = 0; k < 4; ++k) slot(x)[k] += weight * rgba[k];
    }
    float* slot(int x) { return &m_row[4 * static_cast<size_t>(x + m_reach)]; }

    const CubeLevel& m_fine;
    const std::vector<float>& m_weights;
    std::vector<float> m_taps;
    int m_reach;
    std::vector<float> m_row;
};

/// Coarse rows [first, last) of one face.
void filter_band(RowReducer reducer, int face, int first, int last, const std::vector<float>& coarse_weight,
                 CubeLevel& coarse) {
    const int n = coarse.size(), top = 2 * first - reducer.reach(), rows = 2 * (last - first) + 2 * reducer.reach();
    const size_t stride = 4 * static_cast<size_t>(n);
    std::vector<float> reduced(rows * stride);
    for (int r = 0; r < rows; ++r) reducer.reduce(face, top + r, &reduced[r * stride]);
    for (int y = first; y < last; ++y) {
        float* out = coarse.at(face, 0, y);
        for (size_t t = 0; t < reducer.taps().size(); ++t) {
            const float tap = reducer.taps()[t];
            const float* in = &reduced[(2 * static_cast<size_t>(y - first) + t) * stride];
            for (size_t k = 0; k < stride; ++k) out[k] = t == 0 ? tap * in[k] : out[k] + tap * in[k];
        }
        const float* weight = &coarse_weight[static_cast<size_t>(y) * n];
        for (size_t k = 0; k < stride; ++k) out[k] *= weight[k / 4];
    }
}

}  // namespace

CubeFilter::CubeFilter(int size, PyramidKernel kernel)
    : m_taps(kernel_taps(kernel)), m_drift(kernel_drift(kernel)), m_fine(solid_angles(size)) {}

FaceField CubeFilter::expected_factor() const {
    FaceField a = m_coarse;
    const int n = a.size;
    const auto along = [&](int i) { return (i + 0.5) / n - 1.0; };
    for_each_index(n, [&](int y) {
        for (int x = 0; x < n; ++x) {
            const double u2 = along(x) * along(x), v2 = along(y) * along(y), r2 = u2 + v2, z4 = r2 * r2 - 8.0 * u2 * v2;
            double& value = a.values[static_cast<size_t>(y) * n + x];
            value = std::sqrt(value) * std::exp(m_drift[0] * r2 + m_drift[1] * r2 * r2 + (m_drift[2] + m_drift[3] * r2) * z4);
        }
    });
    return a;
}

// Ends with a, so that a constant stays exactly constant.
void CubeFilter::balance() {
    FaceField a = expected_factor();
    FaceField b = quotient(m_fine, spread(a, m_taps));
    for (int step = 0; step < kMaxBalanceSteps; ++step) {
        const double coarse_error = relax(a, m_coarse, gathered(b, m_taps));
        const double fine_error = relax(b, m_fine, spread(a, m_taps));
        if (std::max(coarse_error, fine_error) < kBalanceTolerance) break;
    }
    a = quotient(m_coarse, gathered(b, m_taps));
    m_fine_weight = whole_face(b);
    m_coarse_weight = whole_face(quotient(a, m_coarse));
}

void CubeFilter::coarser(const CubeLevel& fine, CubeLevel& coarse) {
    if (fine.size() > 2) {
        m_coarse = summed_by_four(m_fine);
        balance();
    } else {  // all texels are alike
        m_fine_weight.assign(4, 1.0f);
        m_coarse_weight.assign(1, 1.0f);
    }
    const int n = coarse.size(), bands = (n + kBandRows - 1) / kBandRows;
    for_each_index(6 * bands, [&](int task) {
        const int first = task % bands * kBandRows;
        filter_band(RowReducer(fine, m_fine_weight, m_taps), task / bands, first, std::min(n, first + kBandRows),
                    m_coarse_weight, coarse);
    });
    coarse.fill_borders();
    m_fine = std::move(m_coarse);
}

}  // namespace burnish
