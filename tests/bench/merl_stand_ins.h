// Materials of the MERL set without its tables: the formula of the published SGD rows, and networks that learned the tables.
#pragma once

#include <burnish/fit/brdf_grid.h>

#include <filesystem>
#include <string>
#include <vector>

namespace merl {

/// A row of a CSV file: the name of a material and its numbers.
struct Row {
    std::string material;
    std::vector<double> numbers;
};

/// Throws std::runtime_error where there is no such file.
std::vector<Row> read_rows(const std::filesystem::path& csv);

/// f by the SGD formula and its published G1, in double, for rows of sgd_bagher2012_bbm.csv.
burnish::Channels sgd(const Row& row, const burnish::GridAngles& angles);

/// f by a network of nbrdf_merl_80.csv: two hidden layers of 21 (Sztrajman et al. 2021).
burnish::Channels network(const Row& row, const burnish::GridAngles& angles);

}  // namespace merl
