// A file that runs others: `experiment = "all"`, `include = ["a.toml", "b.toml"]`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace raysweep {

struct IncludeList {
  std::string name;                // of the folder that the experiments' folders go to
  std::vector<std::string> files;  // in order, found from where the list stands
};

/// The list that `text` states; none where it states an experiment itself. `file` is for messages and to find
/// the files. Throws RequestError with one line per error: what is no file, what includes files itself, what
/// is named twice, and any key beside experiment, title and include.
[[nodiscard]] std::optional<IncludeList> read_include_list(const std::string& text, const std::string& file);

}  // namespace raysweep
