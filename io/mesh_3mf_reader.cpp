#include "io/mesh_3mf.h"

#include <array>
#include <limits>

#include "geometry/affine_transform.h"
#include "io/lib3mf_handle.h"
#include "io/mesh_file.h"

namespace voroprobe
{

namespace
{

namespace fs = std::filesystem;

//! Components may name components that name components: a small file can stand for more than any memory
//! holds.
constexpr std::size_t kMostFaces = std::numeric_limits<std::int32_t>::max();
constexpr int kDeepestNesting = 64;

AffineTransform affine(const NMR::MODELTRANSFORM& transform)
{
    const auto& m = transform.m_fFields;
    const auto column = [&m](int i) { return Vec3{m[0][i], m[1][i], m[2][i]}; };
    return {{{column(0), column(1), column(2)}}, column(3)};
}

AffineTransform scaling(double factor)
{
    return {{{Vec3{factor, 0, 0}, Vec3{0, factor, 0}, Vec3{0, 0, factor}}}, {}};
}

//! Walks from the items on the plate down to the meshes.
class PlateReader
{
public:
    explicit PlateReader(const fs::path& path) : path_(path) {} //!< for messages

    std::vector<MeshPart> run(std::string& package)
    {
        open(package);
        const AffineTransform mm = scaling(mm_per_unit());
        Lib3mfHandle items;
        check(NMR::lib3mf_model_getbuilditems(model_.get(), items.receive()), model_);
        BOOL there_is_one = 0;
        while (NMR::lib3mf_builditemiterator_movenext(items.get(), &there_is_one) == 0 && there_is_one != 0)
        {
            Lib3mfHandle item;
            check(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.receive()), items);
            parts_.push_back(part_of(item, mm));
        }
        if (parts_.empty())
            fail_reading(path_, "no object lies on its plate");
        return std::move(parts_);
    }

private:
    void check(LIB3MFRESULT result, const Lib3mfHandle& object) const
    {
        if (result != 0)
            fail_reading(path_, lib3mf_reason(object));
    }

    void open(std::string& package)
    {
        if (NMR::lib3mf_createmodel(model_.receive()) != 0)
            fail_reading(path_, "lib3mf makes no model");
        Lib3mfHandle reader;
        check(NMR::lib3mf_model_queryreader(model_.get(), "3mf", reader.receive()), model_);
        check(NMR::lib3mf_reader_readfrombuffer(reader.get(), reinterpret_cast<BYTE*>(package.data()),
                                                package.size()),
              reader);
    }

    [[nodiscard]] double mm_per_unit() const
    {
        DWORD unit = 0;
        check(NMR::lib3mf_model_getunit(model_.get(), &unit), model_);
        switch (unit)
        {
        case NMR::MODELUNIT_MICROMETER:
            return 1e-3;
        case NMR::MODELUNIT_MILLIMETER:
            return 1.0;
        case NMR::MODELUNIT_CENTIMETER:
            return 10.0;
        case NMR::MODELUNIT_INCH:
            return 25.4;
        case NMR::MODELUNIT_FOOT:
            return 304.8;
        case NMR::MODELUNIT_METER:
            return 1e3;
        default:
            fail_reading(path_,
                         "its unit is number " + std::to_string(unit) + ", which lib3mf does not tell");
        }
    }

    MeshPart part_of(const Lib3mfHandle& item, const AffineTransform& mm_from_plate)
    {
        Lib3mfHandle object;
        check(NMR::lib3mf_builditem_getobjectresource(item.get(), object.receive()), item);
        NMR::MODELTRANSFORM transform{};
        check(NMR::lib3mf_builditem_getobjecttransform(item.get(), &transform), item);
        MeshPart part{.name = name_of(object), .color = color_of(object), .mesh = {}};
        append_object(part, object, mm_from_plate * affine(transform), 0);
        return part;
    }

    [[nodiscard]] static std::string name_of(const Lib3mfHandle& object)
    {
        return lib3mf_text([&](char* text, ULONG size, ULONG* length)
                           { return NMR::lib3mf_object_getnameutf8(object.get(), text, size, length); });
    }

    //! nullopt for an object without material, and for those whose material is no plain colour.
    [[nodiscard]] std::optional<Color> color_of(const Lib3mfHandle& object) const
    {
        Lib3mfHandle handler;
        NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
        if (NMR::lib3mf_object_createdefaultpropertyhandler(object.get(), handler.receive()) != 0 ||
            NMR::lib3mf_defaultpropertyhandler_getpropertytype(handler.get(), &type) != 0)
            return std::nullopt;
        if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS)
            return material_color(handler);
        NMR::MODELMESHCOLOR_SRGB color{};
        if (type == NMR::MODELPROPERTYTYPE_COLOR &&
            NMR::lib3mf_defaultpropertyhandler_getcolor(handler.get(), 0, &color) == 0)
            return Color{color.m_Red, color.m_Green, color.m_Blue};
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Color> material_color(const Lib3mfHandle& handler) const
    {
        DWORD group = 0;
        DWORD index = 0;
        Lib3mfHandle materials;
        Color color;
        BYTE alpha = 0;
        if (NMR::lib3mf_defaultpropertyhandler_getbasematerial(handler.get(), &group, &index) != 0 ||
            NMR::lib3mf_model_getbasematerialbyid(model_.get(), group, materials.receive()) != 0 ||
            NMR::lib3mf_basematerial_getdisplaycolor(materials.get(), index, &color.red, &color.green,
                                                     &color.blue, &alpha) != 0)
            return std::nullopt;
        return color;
    }

    void append_object(MeshPart& part, const Lib3mfHandle& object, const AffineTransform& mm_from_object,
                       int depth)
    {
        if (depth > kDeepestNesting)
            fail_reading(path_,
                         "its components are nested more than " + std::to_string(kDeepestNesting) + " deep");
        BOOL is_mesh = 0;
        check(NMR::lib3mf_object_ismeshobject(object.get(), &is_mesh), object);
        if (is_mesh != 0)
            append_mesh(part.mesh, object, mm_from_object);
        else
            append_components(part, object, mm_from_object, depth);
    }

    void append_components(MeshPart& part, const Lib3mfHandle& object, const AffineTransform& mm_from_object,
                           int depth)
    {
        DWORD count = 0;
        check(NMR::lib3mf_componentsobject_getcomponentcount(object.get(), &count), object);
        for (DWORD i = 0; i < count; ++i)
        {
            Lib3mfHandle component;
            Lib3mfHandle child;
            NMR::MODELTRANSFORM transform{};
            check(NMR::lib3mf_componentsobject_getcomponent(object.get(), i, component.receive()), object);
            check(NMR::lib3mf_component_getobjectresource(component.get(), child.receive()), component);
            check(NMR::lib3mf_component_gettransform(component.get(), &transform), component);
            append_object(part, child, mm_from_object * affine(transform), depth + 1);
        }
    }

    void append_mesh(TriangleMesh& whole, const Lib3mfHandle& object, const AffineTransform& mm_from_object)
    {
        TriangleMesh mesh = mesh_of(object);
        faces_read_ += mesh.faces.size();
        if (faces_read_ > kMostFaces || whole.vertices.size() + mesh.vertices.size() > kMostFaces)
            fail_reading(path_, "its plate holds more than " + std::to_string(kMostFaces) + " faces");
        transform(mesh, mm_from_object);
        const auto first = static_cast<std::uint32_t>(whole.vertices.size());
        whole.vertices.insert(whole.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const TriangleMesh::Face& face : mesh.faces)
            whole.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    }

    [[nodiscard]] TriangleMesh mesh_of(const Lib3mfHandle& object) const
    {
        DWORD vertex_count = 0;
        DWORD face_count = 0;
        check(NMR::lib3mf_meshobject_getvertexcount(object.get(), &vertex_count), object);
        check(NMR::lib3mf_meshobject_gettrianglecount(object.get(), &face_count), object);
        std::vector<NMR::MODELMESHVERTEX> vertices(vertex_count);
        std::vector<NMR::MODELMESHTRIANGLE> faces(face_count);
        if (vertex_count > 0)
            check(NMR::lib3mf_meshobject_getvertices(object.get(), vertices.data(), vertex_count, nullptr),
                  object);
        if (face_count > 0)
            check(NMR::lib3mf_meshobject_gettriangleindices(object.get(), faces.data(), face_count, nullptr),
                  object);
        TriangleMesh mesh;
        for (const auto& v : vertices)
            mesh.vertices.push_back({v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2]});
        for (const auto& f : faces)
            mesh.faces.push_back({f.m_nIndices[0], f.m_nIndices[1], f.m_nIndices[2]});
        return mesh;
    }

    const fs::path& path_;
    Lib3mfHandle model_;
    std::size_t faces_read_ = 0;
    std::vector<MeshPart> parts_;
};

} // namespace

std::vector<MeshPart> read_3mf(const fs::path& path)
{
    std::string package = read_whole_file(path);
    return parse_3mf(package, path);
}

std::vector<MeshPart> parse_3mf(std::string& package, const fs::path& path)
{
    return PlateReader(path).run(package);
}

} // namespace voroprobe
