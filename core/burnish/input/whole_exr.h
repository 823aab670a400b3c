// Whether an EXR is all there: every chunk of it, not only a header that promises them.
#pragma once

#include <string>

namespace burnish {

/// True when every chunk of every part lies in the file, as its table says; nothing is unpacked. False, too, for what is no EXR that
/// burnish reads. `attribute`: set to the text of that name in the first part's header, "" where there is none.
bool is_whole_exr(const std::string& file, const std::string& name, std::string& attribute);

}  // namespace burnish
