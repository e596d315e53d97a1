#!/usr/bin/env python3
"""Does the check find what it is there to find? Small trees, one mistake each."""

import unittest

import include_rules
import rules


def tree(**changes):
    """A small tree that keeps the rules, with some files added or replaced."""
    files = {
        "src/support/error.h": ["<stdexcept>"],
        "src/geometry/vec3.h": ["<cmath>", '"support/error.h"'],
        "src/volume/volume.h": ['"geometry/vec3.h"'],
        "src/mesh/triangle_mesh.h": ['"geometry/vec3.h"'],
        "oracles/surface_oracle.h": ['"geometry/vec3.h"'],
        "oracles/trilinear_oracle.h": ['"oracles/surface_oracle.h"', '"volume/volume.h"'],
        "src/mesher/seeded_mesher.h": ['"mesh/triangle_mesh.h"', '"oracles/surface_oracle.h"'],
        "src/mesher/seeded_mesher.cpp": ['"mesher/seeded_mesher.h"', "<CGAL/Delaunay_triangulation_3.h>"],
        "io/volume_reader.h": ['"volume/volume.h"'],
        "io/volume_reader.cpp": ['"io/volume_reader.h"', "<itkImage.h>", "<sys/stat.h>"],
        "src/cli/main.cpp": ['"io/volume_reader.h"', '"mesher/seeded_mesher.h"', "<CLI/CLI.hpp>"],
    }
    files.update(changes)
    return {
        path: include_rules.INCLUDE.findall("\n".join("#include " + name for name in names))
        for path, names in files.items()
    }


class IncludeRules(unittest.TestCase):
    def assert_found(self, words, **changes):
        found = include_rules.violations(tree(**changes))
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_a_tree_that_keeps_the_rules_passes(self):
        self.assertEqual(include_rules.violations(tree()), [])

    def test_an_upward_include_is_found(self):
        self.assert_found(
            ["src/mesh/topology.cpp", "src/mesher/seeded_mesher.h"],
            **{"src/mesh/topology.cpp": ['"mesher/seeded_mesher.h"']},
        )

    def test_the_mesher_may_include_one_oracle_header_only(self):
        self.assert_found(
            ["src/mesher", "oracles/trilinear_oracle.h"],
            **{"src/mesher/probing.cpp": ['"oracles/trilinear_oracle.h"']},
        )

    def test_a_third_party_in_a_folder_that_does_not_own_it_is_found(self):
        self.assert_found(
            ["src/mesh/topology.cpp", "CGAL"],
            **{"src/mesh/topology.cpp": ["<CGAL/Surface_mesh.h>"]},
        )

    def test_a_third_party_in_a_shared_header_is_found(self):
        self.assert_found(
            ["io/volume_reader.h", "ITK", "src/cli/main.cpp"],
            **{"io/volume_reader.h": ['"volume/volume.h"', "<itkImage.h>"]},
        )

    def test_a_third_party_reached_through_a_shared_header_is_found(self):
        self.assert_found(
            ["io/itk_types.h", "ITK"],
            **{"io/volume_reader.h": ['"io/itk_types.h"'], "io/itk_types.h": ["<itkImage.h>"]},
        )

    def test_a_third_party_in_a_private_header_passes(self):
        changes = {"io/volume_itk.h": ["<itkImage.h>"], "io/volume_itk.cpp": ['"io/volume_itk.h"']}
        self.assertEqual(include_rules.violations(tree(**changes)), [])

    def test_an_unknown_third_party_is_found(self):
        self.assert_found(
            ["<pcl/point_cloud.h>"],
            **{"src/mesh/topology.cpp": ["<pcl/point_cloud.h>"]},
        )

    def test_a_header_included_without_its_folder_is_found(self):
        self.assert_found(
            ["src/mesh/topology.cpp", "triangle_mesh.h"],
            **{"src/mesh/topology.cpp": ['"triangle_mesh.h"']},
        )

    def test_a_folder_without_a_rule_is_found(self):
        self.assert_found(["src/extra"], **{"src/extra/thing.cpp": ["<vector>"]})

    def test_the_rules_have_no_cycle(self):
        for folder in rules.MAY_INCLUDE:
            self.assertNotIn(folder, include_rules.opened(folder, rules.MAY_INCLUDE))


if __name__ == "__main__":
    unittest.main()
