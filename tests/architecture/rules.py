"""Who may include whom, and which third party is named where. docs/design.md, section 2, says why.

Change a rule here and there together.
"""

# Folder: what its files may include. A folder's name opens all of its headers and, in turn, what that folder may include; a
# header's name opens this header alone.
MAY_INCLUDE = {
    "src/support": [],
    "src/geometry": ["src/support"],
    "src/volume": ["src/geometry"],
    "src/mesh": ["src/geometry"],
    "oracles": ["src/volume", "src/mesh"],
    "src/mesher": ["oracles/surface_oracle.h", "oracles/coverage.h", "src/mesh"],
    "src/certificate": ["oracles/surface_oracle.h", "oracles/coverage.h", "src/mesh", "src/volume"],
    "io": ["src/volume", "src/mesh"],
    "src/labels": ["src/volume", "oracles", "src/mesher", "src/certificate"],
    "src/postprocess": ["oracles/surface_oracle.h", "src/mesh", "src/certificate"],
    "src/compare": ["src/volume", "oracles", "src/mesher", "src/certificate", "src/labels"],
    "src/cli": ["src/volume", "oracles", "src/mesher", "io", "src/certificate", "src/labels", "src/postprocess", "src/compare"],
}

# Third party: how its headers begin, and the folders whose files may name it.
THIRD_PARTIES = {
    "ITK": (("itk", "gdcm"), ["io", "src/labels"]),
    "OpenVDB": (("openvdb/",), ["io", "oracles", "src/compare"]),
    "OpenMesh": (("OpenMesh/",), ["io", "src/postprocess"]),
    "lib3mf": (("lib3mf/", "Model/COM/NMR_"), ["io"]),
    "VTK": (("vtk",), ["io", "src/compare"]),
    "libtiff": (("tiffio.h",), ["io"]),
    "meshoptimizer": (("meshoptimizer.h",), ["src/compare"]),
    "zlib": (("zlib.h",), ["io", "src/compare"]),
    "CGAL": (("CGAL/", "boost/"), ["oracles", "src/mesher", "src/certificate", "src/postprocess", "src/compare", "src/labels"]),
    "TBB": (("tbb/", "oneapi/tbb"), ["src/support", "src/volume", "src/mesher", "src/certificate", "src/labels", "src/compare"]),
    "muParser": (("muParser",), ["oracles"]),
    "CLI11": (("CLI/",), ["src/cli"]),
    "nlohmann-json": (("nlohmann/",), ["src/cli", "src/compare"]),
}

# Headers of the operating system that may be named anywhere; those of the C++ library have no extension.
SYSTEM_HEADERS = {
    "dirent.h", "errno.h", "fcntl.h", "malloc.h", "poll.h", "pthread.h", "signal.h", "termios.h", "unistd.h",
}
SYSTEM_PREFIXES = ("sys/",)
