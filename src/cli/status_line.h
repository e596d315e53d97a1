#pragma once

#include <string>

namespace voroprobe
{

//! A line on the terminal that the next one takes the place of; nothing where stderr is no terminal.
class StatusLine
{
public:
    explicit StatusLine(bool shown);
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;
    ~StatusLine();

    void tell(const std::string& text) const;

private:
    bool shown_;
};

} // namespace voroprobe
