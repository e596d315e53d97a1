#include "mesher/contact_separation.h"
namespace voroprobe
{
std::size_t separate_contacts(BoundaryComplex&)
{
    return 0;
}
void split_pinched_edges(BoundaryComplex&) {}
} // namespace voroprobe
