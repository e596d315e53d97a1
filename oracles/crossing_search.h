#pragma once

#include <cstddef>
#include <vector>

#include "oracles/scalar_field.h"
#include "oracles/surface_oracle.h"

namespace voroprobe
{

//! Finds where a field changes side along one segment, of which a part lies in the domain.
class CrossingSearch
{
public:
    //! A point of the segment with the field's value there.
    struct Probe
    {
        double t;
        double value; //!< 0 where the field is NaN: no evidence about the neighbourhood
        bool inside;
    };

    //! Lengths in scan units, > 0.
    struct Tolerances
    {
        double resolution; //!< what the field does not settle is not divided below it
        double root;       //!< length of the bracket a crossing is the middle of
    };

    CrossingSearch(const ScalarField& field, const Segment3& segment, const Tolerances& tolerances,
                   std::vector<Crossing>& crossings);

    [[nodiscard]] Probe probe(double t) const;

    void append(double t, bool on_border) { crossings_.push_back({t, segment_.at(t), on_border}); }

    //! Appends every change of side between two probes, in order.
    void search(const Probe& from, const Probe& to);

private:
    [[nodiscard]] Point3 at(double t) const { return t == 1.0 ? segment_.target : segment_.at(t); }
    [[nodiscard]] double root(Probe low, Probe high) const;

    const ScalarField& field_;
    const Segment3& segment_;
    std::vector<Crossing>& crossings_;
    double shortest_; //!< the tolerances, in the segment's parameter
    double root_tolerance_;
    std::size_t divisions_ = 0;
};

} // namespace voroprobe
