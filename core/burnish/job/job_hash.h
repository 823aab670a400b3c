// By what an output is known to be of a job: the SHA-256 of all settings that its pixels may depend on, kept in its header.
#pragma once

#include <burnish/job/job.h>

#include <string>

namespace burnish {

/// The attribute of an output's header.
inline constexpr const char* kJobHashAttribute = "burnish:job";

/// 64 hexadecimal digits, the same for jobs that differ only in threads, in which frames they do and where outputs go. Files count by
/// name. `kind`: of output, as a bandwidth picture is no composite.
std::string job_hash(const Job& job, const std::string& kind = "composite");

}  // namespace burnish
