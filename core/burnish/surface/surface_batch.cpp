#include <burnish/surface/surface_batch.h>

namespace burnish {

void SurfaceBatch::clear() {
    pixel.clear();
    for (Vec3Planes* planes : {&p, &n, &ng, &t, &wo, &tint}) planes->clear();
    for (std::vector<float>* plane : {&roughness, &anisotropy, &rotation, &weight}) plane->clear();
}

}  // namespace burnish
