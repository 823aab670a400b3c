// Several EXR files put together as one. Parts are copied as they are stored, chunk by chunk: types, compression, windows and every bit
// of their pixels stay.
#pragma once

#include <string>
#include <vector>

namespace burnish {

/// All parts of a file. `name`: of those that have none; `view`: of those that tell none.
struct StoredParts {
    std::string file, name, view;
};

/// One multi-part file of all of them, in their order; parts whose names come twice get a number. Whole or not at all.
/// Throws Error(read_failed | write_failed).
void join_parts(const std::string& target, const std::vector<StoredParts>& sources);

}  // namespace burnish
