// Scans, where they are at hand: VOROPROBE_DATA, or ../shared/data beside the sources.

#include <cstdlib>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include "io/volume_reader.h"
#include "volume/inventory.h"

namespace voroprobe
{
namespace
{

struct Scan
{
    const char* file;
    double isovalue;
    std::size_t surfaces; //!< by face saddles alone, those of value 0 outside
    std::size_t joined;   //!< at most so many, by body saddles and by face saddles of value 0
};

void PrintTo(const Scan& scan, std::ostream* out)
{
    *out << scan.file;
}

class InventoryOfScan : public testing::TestWithParam<Scan>
{
};

INSTANTIATE_TEST_SUITE_P(Scans, InventoryOfScan,
                         testing::Values(Scan{"cranium_ct.nrrd", 226.5, 171, 5},
                                         Scan{"headsq_ct.nrrd", 1150.5, 74, 5},
                                         Scan{"bonsai_ct.nii.gz", 40.5, 954, 50},
                                         Scan{"mra_vessels.nii.gz", 60.5, 85, 5},
                                         Scan{"silicium.mha", 180.5, 114, 0}, Scan{"neghip.mha", 60.5, 15, 0},
                                         Scan{"fuel.mha", 30.5, 10, 0}, Scan{"skull_cgal.nrrd", 2.9, 2, 0}));

TEST_P(InventoryOfScan, lists_the_surfaces_counted_by_others_and_they_form_a_tree)
{
    const char* data = std::getenv("VOROPROBE_DATA");
    const auto path =
        std::filesystem::path(data ? data : VOROPROBE_SOURCE_DIR "/../shared/data") / GetParam().file;
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "needs " << path;
    const auto volume = std::make_shared<const Volume>(read_volume(path.string()).volume);
    const Inventory inventory(*make_height_field(level_volume(volume, GetParam().isovalue)));
    EXPECT_LE(inventory.surfaces().size(), GetParam().surfaces);
    EXPECT_GE(inventory.surfaces().size() + GetParam().joined, GetParam().surfaces);
    EXPECT_LT(inventory.memory_bytes(), 5 * volume->geometry.sample_count());

    std::size_t unexplained = 0;
    const auto [columns, rows, slices] = inventory.runs().sample_count();
    for (int k = 0; k < slices; ++k)
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                for (const Region next : {inventory.region(i, j + 1, k), inventory.region(i, j, k + 1)})
                    unexplained +=
                        next != inventory.region(i, j, k) &&
                                inventory.surface_between(inventory.region(i, j, k), next) == kNoSurface
                            ? 1
                            : 0;
    EXPECT_EQ(unexplained, 0U);
    for (const ScanSurface& surface : inventory.surfaces())
        EXPECT_EQ(surface.euler_characteristic % 2, 0);
}

} // namespace
} // namespace voroprobe
