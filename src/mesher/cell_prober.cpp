#include "mesher/cell_prober.h"

namespace voroprobe
{

CellProber::CellProber(const RestrictedDelaunay& restricted, const ProbedDomain& domain, double probe_radius,
                       double reach)
    : domain_(domain), probe_radius_(probe_radius),
      probing_(restricted.oracle(), probe_radius, counts_, never_stops_), slab_probing_(probing_),
      mesh_(restricted, reach), is_news_([this](const Point3& crossing) { return !mesh_.explains(crossing); })
{
}

bool CellProber::probe_by_few(VertexHandle vertex)
{
    cell_.assign(vertex);
    mesh_.assign(cell_.site(), cell_.star());
    cell_.outline(domain_, outline_);
    return slab_probing_.probe(outline_, is_news_, SlabProbing::Effort::kFewProbes) ==
           SlabProbing::Outcome::kProbed;
}

bool CellProber::is_probed_by_its_edges(VertexHandle vertex)
{
    cell_.assign(vertex);
    return cell_.is_within(domain_) && cell_.cylinder().radius <= probe_radius_;
}

} // namespace voroprobe
