// An open EXR file: its layers, windows and attributes, and reading of chosen channels. The only caller of OpenImageIO
// for AOV pixels.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/frame.h>
#include <burnish/input/layers.h>

#include <memory>
#include <string>
#include <vector>

namespace burnish {

/// Channel `channel` of the file goes to component `component` of `image`, from its row `top` on.
struct ChannelRead {
    Channel channel;
    Image* image;
    int component;
    int top = 0;
};

class ExrFile {
public:
    /// Opens and checks the headers; throws Error(read_failed) as check_exr_header does, Error(bad_argument) for a view the
    /// file does not have. `view`: "" = the first; ignored by mono files.
    ExrFile(const std::string& file, const std::string& view);
    ~ExrFile();

    const std::string& name() const { return m_name; }
    /// View that is read, "" for mono files.
    const std::string& view() const { return m_view; }
    /// All that there are, in the order of the file.
    const std::vector<std::string>& views() const { return m_views; }
    /// They are told apart by the names of channels, not by parts.
    bool has_views_in_one_part() const;
    const std::vector<Layer>& layers() const { return m_layers; }
    /// The layer of that exact name, null when there is none.
    const Layer* find_layer(const std::string& layer) const;

    Window data_window(int part) const;
    Window display_window() const;
    /// Rows of a part that are unpacked together, whichever of them are wanted.
    int block_rows(int part) const;
    /// How a part is packed: "zip", "dwaa", ...
    std::string compression(int part) const;
    /// Attributes of a part.
    std::shared_ptr<const Metadata> metadata(int part) const;

    /// Decodes the pixels of `window` into images of its width; those outside a part's data window stay as they are. Other
    /// rows are not unpacked, except those of a block with wanted ones. Throws Error(read_failed) for missing or damaged pixels.
    void read(const std::vector<ChannelRead>& reads, const Window& window) const;

private:
    struct Parts;
    std::string m_name, m_view;
    std::vector<std::string> m_views;
    std::vector<Layer> m_layers;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace burnish
