// Which axis of a world points up: renderers disagree, files rarely say.
#pragma once

namespace burnish {

enum class UpAxis { automatic, y, z };

}  // namespace burnish
