#include "bench/file_to_stl.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/mesh_reader.h"
#include "io/volume_reader.h"
#include "support/error.h"

namespace voroprobe::bench
{

namespace
{

//! A folder for one file, gone with it.
class StlFile
{
public:
    StlFile() : folder_(make_folder()) {}
    ~StlFile()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    StlFile(const StlFile&) = delete;
    StlFile& operator=(const StlFile&) = delete;

    [[nodiscard]] std::filesystem::path path() const { return folder_ / "mesh.stl"; }

private:
    static std::filesystem::path make_folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "bench_versus.XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw OutputError(name + ": cannot be made");
        return name;
    }

    std::filesystem::path folder_;
};

void discard_output()
{
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
}

void run_program(const std::vector<std::string>& words)
{
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str())); // execv promises not to write there
    arguments.push_back(nullptr);

    const pid_t process = fork();
    if (process < 0)
        throw std::runtime_error(words.front() + ": cannot be started");
    if (process == 0)
    {
        discard_output();
        execv(arguments.front(), arguments.data());
        _exit(EXIT_FAILURE);
    }
    int status = 0;
    waitpid(process, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw std::runtime_error(words.front() + ": ended with status " + std::to_string(status));
}

class Command final : public Contestant
{
public:
    Command(const MeshingTask& task, std::filesystem::path volume) : task_(task), volume_(std::move(volume))
    {
    }

    void mesh(StageClock& clock) override
    {
        clock.begin("program");
        run_program({VOROPROBE_EXECUTABLE, "mesh", volume_.string(), "--isovalue", text(task_.isovalue),
                     "--size", text(task_.max_facet_radius), "--angle", text(task_.min_facet_angle_deg),
                     "--distance", text(task_.max_facet_distance), "--floor", text(task_.floor_radius),
                     "--threads", std::to_string(task_.threads), "--output", stl_.path().string()});
    }

    [[nodiscard]] TriangleMesh result() const override { return read_mesh(stl_.path()); }

private:
    static std::string text(double number)
    {
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), "%.17g", number);
        return digits.data();
    }

    MeshingTask task_;
    std::filesystem::path volume_;
    StlFile stl_;
};

//! Faces as they are; normals are left to the reader.
void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary);
    const std::array<char, 80> header{};
    file.write(header.data(), header.size());
    const auto count = static_cast<std::uint32_t>(mesh.faces.size());
    file.write(reinterpret_cast<const char*>(&count), sizeof count);
    for (const TriangleMesh::Face& face : mesh.faces)
    {
        std::array<float, 12> numbers{};
        std::size_t next = 3;
        for (const std::uint32_t vertex : face)
            for (std::size_t axis = 0; axis < 3; ++axis)
                numbers[next++] = static_cast<float>(mesh.vertices[vertex][axis]);
        file.write(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
        const std::uint16_t attributes = 0;
        file.write(reinterpret_cast<const char*>(&attributes), sizeof attributes);
    }
    if (!file.flush())
        throw OutputError(path.string() + ": cannot be written");
}

class FileToStl final : public Contestant
{
public:
    using Make = std::function<std::unique_ptr<Contestant>(const MeshingTask&)>;

    FileToStl(const MeshingTask& task, std::filesystem::path volume, Make make)
        : task_(task), volume_(std::move(volume)), make_(std::move(make))
    {
    }

    void mesh(StageClock& clock) override
    {
        clock.begin("reading");
        MeshingTask task = task_;
        task.volume = std::make_shared<const Volume>(read_volume(volume_).volume);
        const auto contestant = make_(task);
        contestant->mesh(clock);
        clock.begin("writing");
        write_stl(contestant->result(), stl_.path());
    }

    [[nodiscard]] TriangleMesh result() const override { return read_mesh(stl_.path()); }

private:
    MeshingTask task_;
    std::filesystem::path volume_;
    Make make_;
    StlFile stl_;
};

} // namespace

std::unique_ptr<Contestant> make_command(const MeshingTask& task, const std::filesystem::path& volume)
{
    return std::make_unique<Command>(task, volume);
}

std::unique_ptr<Contestant>
make_file_to_stl(const MeshingTask& task, const std::filesystem::path& volume,
                 std::function<std::unique_ptr<Contestant>(const MeshingTask&)> make)
{
    return std::make_unique<FileToStl>(task, volume, std::move(make));
}

} // namespace voroprobe::bench
