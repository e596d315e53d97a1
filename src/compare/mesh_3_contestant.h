#pragma once

// CGAL's Mesh_3 on its own gray image domain: facet criteria only, no optimization of cells.

#include <algorithm>
#include <cstring>
#include <iostream>
#include <map>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_3/initialize_triangulation_from_gray_image.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/refine_mesh_3.h>

#include "compare/contestant.h"
#include "compare/peer_field.h"

namespace voroprobe
{

inline CGAL::Image_3 make_image(const PeerField& field)
{
    const auto& [size, spacing] = std::tie(field.size, field.spacing);
    _image* image = _createImage(size[0], size[1], size[2], 1, spacing.x, spacing.y, spacing.z, sizeof(float),
                                 WK_FLOAT, SGN_SIGNED);
    std::memcpy(image->data, field.samples.data(), field.samples.size() * sizeof(float));
    return CGAL::Image_3(image, CGAL::Image_3::OWN_THE_DATA);
}

//! CGAL's scan reports its progress on std::cout; a contestant keeps quiet.
class SilencedOutput
{
public:
    SilencedOutput() : previous_(std::cout.rdbuf(nullptr)) {}
    ~SilencedOutput()
    {
        std::cout.rdbuf(previous_);
        std::cout.clear();
    }
    SilencedOutput(const SilencedOutput&) = delete;
    SilencedOutput& operator=(const SilencedOutput&) = delete;

private:
    std::streambuf* previous_;
};

//! `Concurrency`: CGAL::Sequential_tag or CGAL::Parallel_tag.
template <typename Concurrency>
class Mesh3 final : public Contestant
{
public:
    using Domain = CGAL::Labeled_mesh_domain_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
    using Triangulation = typename CGAL::Mesh_triangulation_3<Domain, CGAL::Default, Concurrency>::type;
    using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
    using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

    Mesh3(const MeshingTask& task, Mesh3Seeding seeding) : task_(task), seeding_(seeding)
    {
        const PeerField field = make_peer_field(task);
        isovalue_ = field.isovalue;
        image_ = make_image(field);
        const float lowest = *std::min_element(field.samples.begin(), field.samples.end());
        value_outside_ = std::min<double>(lowest, isovalue_ - 1.0);
    }

    void mesh(StageClock& clock) override
    {
        CGAL::get_default_random() = CGAL::Random(kRandomSeed);
        namespace p = CGAL::parameters;
        const SilencedOutput silenced;
        clock.begin("domain");
        const Domain domain = Domain::create_gray_image_mesh_domain(
            p::image = image_, p::iso_value = isovalue_, p::value_outside = value_outside_,
            p::relative_error_bound = task_.peer_error_bound);
        const Criteria criteria(p::facet_angle = task_.min_facet_angle_deg,
                                p::facet_size = task_.max_facet_radius,
                                p::facet_distance = task_.max_facet_distance);
        if (seeding_ == Mesh3Seeding::kDefault)
        {
            clock.begin("refinement");
            complex_ = CGAL::make_mesh_3<Complex>(domain, criteria, p::no_exude(), p::no_perturb());
            return;
        }
        clock.begin("scan for components");
        initialize_triangulation_from_gray_image(complex_, domain, image_, criteria, isovalue_, float{});
        clock.begin("refinement");
        CGAL::refine_mesh_3(complex_, domain, criteria, p::no_reset_c3t3(), p::no_exude(), p::no_perturb());
    }

    [[nodiscard]] TriangleMesh result() const override
    {
        TriangleMesh mesh;
        std::map<typename Triangulation::Vertex_handle, std::uint32_t> number_of_vertex;
        for (auto facet = complex_.facets_in_complex_begin(); facet != complex_.facets_in_complex_end();
             ++facet)
        {
            TriangleMesh::Face face{};
            for (int corner = 0; corner < 3; ++corner)
            {
                const auto vertex =
                    facet->first->vertex(Triangulation::vertex_triple_index(facet->second, corner));
                const auto [entry, is_new] =
                    number_of_vertex.try_emplace(vertex, static_cast<std::uint32_t>(mesh.vertices.size()));
                if (is_new)
                    mesh.vertices.push_back({vertex->point().x(), vertex->point().y(), vertex->point().z()});
                face[static_cast<std::size_t>(corner)] = entry->second;
            }
            if (complex_.is_in_complex(
                    facet->first)) // the triple runs counter-clockwise seen from within its cell
                std::swap(face[1], face[2]);
            mesh.faces.push_back(face);
        }
        return mesh;
    }

private:
    MeshingTask task_;
    Mesh3Seeding seeding_;
    CGAL::Image_3 image_;
    double isovalue_ = 0.0;
    double value_outside_ = 0.0;
    Complex complex_;
};

} // namespace voroprobe
