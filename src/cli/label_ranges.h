#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labels/label_survey.h"

namespace voroprobe
{

//! Labels that the user names: "all", or numbers and ranges separated by commas, "1,5,7-9".
class LabelRanges
{
public:
    //! \throw UsageError that names the option.
    LabelRanges(std::string_view option, std::string_view text);

    [[nodiscard]] bool contains(LabelValue label) const;

    //! The numbers given by themselves, not in ranges, that are none of `there` (ascending), and the ranges
    //! that hold none of it; as text, "" where there are none.
    [[nodiscard]] std::string not_among(const std::vector<LabelValue>& there) const;

private:
    bool all_ = false;
    std::vector<std::pair<LabelValue, LabelValue>> ranges_; //!< first and last
};

//! Labels for people, ranges drawn together, "1, 5, 7 to 9"; cut off after a few dozen. \pre ascending.
std::string labels_text(const std::vector<LabelValue>& labels);

} // namespace voroprobe
