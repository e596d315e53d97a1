#include "certificate/complaints.h"

#include "support/number_text.h"

namespace voroprobe
{

void Complaints::add(std::size_t count, const std::string& one, const std::string& many)
{
    if (count > 0)
        text_ += (text_.empty() ? "" : ", ") + count_text(count) + ' ' + (count == 1 ? one : many);
}

std::optional<std::string> Complaints::text() const
{
    return text_.empty() ? std::nullopt : std::optional(text_);
}

} // namespace voroprobe
