// Frame ranges and frame patterns: which frames a job has, and the file of each.
//
//   ranges     1-24   1-24x2 or 1-24:2 (every second)   1,3,5-7   -5--1 (negative frames)
//   patterns   ####  as many digits as signs, # alone is four    @@@  as many digits as signs, in the file name only
//              %04d  $F4  <f4>  that many digits                 %d  $F  <f>  without leading zeros
//
// Digits are a minimum: frame 12345 in #### is 12345. A minus sign counts as a digit, as in printf: frame -5 is -005.
// <UDIM> is a texture tile and not a frame.
#pragma once

#include <string>
#include <vector>

namespace burnish {

/// Frames of a range text, in the order given, each once. Throws Error(bad_argument) for text that is no range, a range that
/// runs backwards, or more than a million frames.
std::vector<int> parse_frames(const std::string& text);

/// True when the pattern names another file for each frame.
bool has_frame_token(const std::string& pattern);

/// The file of a frame: every token of the pattern replaced.
std::string frame_file(const std::string& pattern, int frame);

/// Frames of the pattern that exist as files, ascending. Throws Error(bad_argument) for a pattern without a token.
std::vector<int> frames_on_disk(const std::string& pattern);

}  // namespace burnish
