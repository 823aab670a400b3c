#include <burnish/output/exr_threads.h>

#include <OpenImageIO/imageio.h>

namespace burnish {
namespace {

constexpr const char* kSetting = "exr_threads";

}  // namespace

ExrThreads::ExrThreads(int threads) : m_before(OIIO::get_int_attribute(kSetting)) {
    if (threads > 0) OIIO::attribute(kSetting, threads);
}

ExrThreads::~ExrThreads() { OIIO::attribute(kSetting, m_before); }

}  // namespace burnish
