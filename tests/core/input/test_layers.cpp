// Channel names and layers: the rules of the pipeline conventions, and the oddities of real writers.
#include <burnish/input/channel_names.h>
#include <burnish/input/layers.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

PartNames part(const std::string& name, std::vector<std::string> channels, const std::string& view = "") {
    PartNames names{name, view, std::move(channels), {}, {}};
    names.types.assign(names.channels.size(), ChannelType::half);
    return names;
}

/// "layer:rgb" for each layer.
std::vector<std::string> shown(const std::vector<Layer>& layers) {
    std::vector<std::string> result;
    for (const Layer& layer : layers) {
        result.push_back(layer.name + ":");
        for (const Channel& channel : layer.channels) result.back() += channel.component;
    }
    return result;
}

using Strings = std::vector<std::string>;

TEST(ChannelNames, AreSplitAtTheLastDot) {
    const ChannelName name = split_channel("View Layer.Diffuse Col.R");
    EXPECT_EQ(name.layer, "View Layer.Diffuse Col");
    EXPECT_EQ(name.component, "R");
    EXPECT_EQ(split_channel("Z").layer, "");
    EXPECT_EQ(split_channel("Z").component, "Z");
}

TEST(ChannelNames, CompareInOneForm) {
    EXPECT_EQ(normal_form("ViewLayer.Denoising Normal"), "denoisingnormal");
    EXPECT_EQ(normal_form("__Pworld"), "pworld");
    EXPECT_EQ(normal_form("vrayRE_Z_depth"), "zdepth");
    EXPECT_EQ(normal_form("specular_direct"), "speculardirect");
    EXPECT_EQ(normal_form("beauty"), "beauty");
    EXPECT_EQ(normal_component("Alpha"), "a");
    EXPECT_EQ(normal_component("green"), "g");
    EXPECT_EQ(normal_component("Z"), "z");
    EXPECT_EQ(normal_component("ZBack"), "zback");
}

TEST(ChannelNames, LoseTheViewAtTheirEnd) {
    EXPECT_EQ(without_view("rgba_left", "left"), "rgba");
    EXPECT_EQ(without_view("depth.main", "main"), "depth");
    EXPECT_EQ(without_view("left", "left"), "left");
    EXPECT_EQ(without_view("outleft", "left"), "outleft");
}

TEST(Layers, KeepBlenderPassesApart) {
    const auto layers = gather_layers({part("", {"ViewLayer.Normal.X", "ViewLayer.Normal.Y", "ViewLayer.Position.X"})}, "");
    EXPECT_EQ(shown(layers), (Strings{"ViewLayer.Normal:xy", "ViewLayer.Position:x"}));
}

TEST(Layers, TakeBareChannelsOfTheFirstPartAsTheMainLayer) {
    const auto layers = gather_layers({part("", {"R", "G", "B", "A", "Z", "pscale"})}, "");
    EXPECT_EQ(shown(layers), (Strings{":rgba", "Z:z", "pscale:pscale"}));
}

TEST(Layers, TakeThePartNameForBareChannelsOfOtherParts) {
    const auto layers =
        gather_layers({part("rgba", {"R", "G", "B"}), part("normal", {"R", "G", "B"}), part("depth", {"Z"})}, "");
    EXPECT_EQ(shown(layers), (Strings{":rgb", "normal:rgb", "depth:z"}));
}

TEST(Layers, DoNotTakeANamedDataPartForTheBeautyBecauseItComesFirst) {
    const auto layers = gather_layers({part("N", {"R", "G", "B"}), part("rgba", {"R", "G", "B"})}, "");
    EXPECT_EQ(shown(layers), (Strings{"N:rgb", "rgba:rgb"}));
}

TEST(Layers, PreferTheChannelNameOverThePartName) {
    const auto layers = gather_layers({part("a", {"R", "G", "B"}), part("b", {"spec.R"}), part("c", {"spec.G"})}, "");
    EXPECT_EQ(shown(layers), (Strings{":rgb", "spec:rg"}));
}

TEST(Layers, JoinAMainLayerThatIsScatteredOverParts) {
    const auto layers = gather_layers({part("part0", {"R"}), part("part1", {"G"}), part("part2", {"B", "layer.R"})}, "");
    EXPECT_EQ(shown(layers), (Strings{":rgb", "layer:r"}));
}

TEST(Layers, BelongToOneViewOfAMultiPartFile) {
    const std::vector<PartNames> parts = {part("rgba_right", {"R", "G", "B"}, "right"), part("depth_left", {"Z"}, "left"),
                                          part("rgba_left", {"R", "G", "B"}, "left"), part("matte", {"matte.mask"})};
    EXPECT_EQ(views_of(parts), (Strings{"right", "left"}));
    EXPECT_EQ(shown(gather_layers(parts, "right")), (Strings{":rgb", "matte:mask"}));
    const auto left = gather_layers(parts, "left");
    EXPECT_EQ(shown(left), (Strings{"depth:z", "rgba:rgb", "matte:mask"}));
    EXPECT_EQ(left[1].channels[0].part, 2);
}

TEST(Layers, BelongToOneViewOfAMultiViewPart) {
    PartNames names = part("", {"R", "left.R", "normal.X", "normal.left.X", "left.spec.R"});
    names.multi_view = {"right", "left"};
    EXPECT_EQ(views_of({names}), (Strings{"right", "left"}));
    EXPECT_EQ(shown(gather_layers({names}, "right")), (Strings{":r", "normal:x"}));
    EXPECT_EQ(shown(gather_layers({names}, "left")), (Strings{":r", "normal:x", "spec:r"}));
}

TEST(Layers, IgnoreTheViewsOfASinglePartWhenThereAreSeveralParts) {
    PartNames names = part("rgba", {"R", "G", "B"});
    names.multi_view = {"main", "cam1"};
    EXPECT_TRUE(views_of({names, part("depth", {"Z"})}).empty());
}

}  // namespace
}  // namespace burnish
