// How many threads OpenEXR packs and unpacks with.
#pragma once

namespace burnish {

/// Limits OpenEXR's threads, which all files of the process share, while it lives; 0 means all cores.
class ExrThreads {
public:
    explicit ExrThreads(int threads);
    ~ExrThreads();
    ExrThreads(const ExrThreads&) = delete;
    ExrThreads& operator=(const ExrThreads&) = delete;

private:
    int m_before;
};

}  // namespace burnish
