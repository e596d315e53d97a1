#include "cli/warnings.h"

#include <iostream>

namespace voroprobe
{

void print_warnings(const std::vector<std::string>& warnings)
{
    for (const std::string& warning : warnings)
        std::cerr << "voroprobe: warning: " + warning + '\n';
}

} // namespace voroprobe
