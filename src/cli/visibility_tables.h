// What nullscope visibility writes: tables (CSV) with their units in the header, and the diagram.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "telescope/closure.h"
#include "telescope/observation.h"
#include "telescope/stations.h"
#include "telescope/visibility.h"

namespace nullscope::cli {

// Where visibilities are wanted, and what was found there.
struct VisibilityRows {
    std::vector<Baseline> baselines;
    std::vector<double> time_h{}, frequency_ghz{};  // empty, or of each
    std::vector<Station> stations{};                // of an array, with what they see:
    Observation seen{};                             // its baselines are those above
    std::vector<Visibility> found{};
    std::vector<double> noise{};  // empty, or of each: of the real and of the imaginary part
    double whole = 0;             // of I, at the baseline 0
    bool in_jansky = false, polarised = false;
    bool is_line = false;  // baselines are places on a line, ascending
    bool of_array() const { return !stations.empty(); }
};

std::string visibility_csv(const VisibilityRows& rows);
std::string visibility_columns(const VisibilityRows& rows);  // what they mean, for people
std::string closure_phase_csv(const VisibilityRows& rows);   // of an array
std::string closure_amplitude_csv(const VisibilityRows& rows);
std::string visibility_svg(const std::string& title, const VisibilityRows& rows);  // |V| against the baseline's length

}  // namespace nullscope::cli
