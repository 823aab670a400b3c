// SHA-256: by which files and jobs are known again.
#pragma once

#include <iosfwd>
#include <string>

namespace burnish {

/// Of all that is left of a stream, 64 hexadecimal digits; the stream is then at its end, unless it cannot be read.
std::string sha256(std::istream& stream);

}  // namespace burnish
