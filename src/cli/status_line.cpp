#include "cli/status_line.h"

#include <iostream>

#include <unistd.h>

#include "cli/interrupt.h"

namespace voroprobe
{

StatusLine::StatusLine(bool shown) : shown_(shown && isatty(STDERR_FILENO) == 1)
{
    if (shown_)
        set_bar_shown(true);
}

StatusLine::~StatusLine()
{
    if (!shown_)
        return;
    std::cerr << kWipeLine << std::flush;
    set_bar_shown(false);
}

void StatusLine::tell(const std::string& text) const
{
    if (shown_)
        std::cerr << kWipeLine << text << std::flush;
}

} // namespace voroprobe
