// Reads meshes with assimp. It is loaded for the first mesh, because it is not installed
// everywhere.
#include <fmt/core.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "files/parse.h"
#include "files/ply.h"
#include "files/read_whole.h"

namespace lacuna {
namespace {

constexpr std::array<std::string_view, 6> kMeshFormats{"ply", "obj", "stl", "off", "gltf", "glb"};

// The extension of the name, by which assimp reads it. Throws BadRequest for another one.
std::string mesh_format_of(const std::string& name) {
    std::string format = std::filesystem::path(name).extension().string().erase(0, 1);
    std::transform(format.begin(), format.end(), format.begin(), files::lower_case);
    if (std::find(kMeshFormats.begin(), kMeshFormats.end(), format) == kMeshFormats.end())
        throw BadRequest("on", name, "must end in .ply, .obj, .stl, .off, .gltf or .glb");
    return format;
}

}  // namespace
}  // namespace lacuna

#ifdef LACUNA_ASSIMP

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <system_error>

#include "base/loaded_library.h"
#include "base/polling.h"

namespace lacuna {
namespace {

// The functions of assimp that are used. Its library is never closed.
class Assimp {
public:
    static const Assimp& loaded() {
        static const Assimp one;
        return one;
    }

    decltype(&aiImportFile) import_file{};
    decltype(&aiImportFileFromMemory) import_bytes{};
    decltype(&aiGetErrorString) error{};

    const std::string& missing() const { return library_.missing(); }  // empty: all were found

private:
    Assimp() {
        library_.find(import_file, "aiImportFile");
        library_.find(import_bytes, "aiImportFileFromMemory");
        library_.find(error, "aiGetErrorString");
    }

    LoadedLibrary library_{"libassimp.so.5", "assimp", "libassimp5"};
};

// Appends the triangles of a node and of those below it, without points and lines.
void append(const aiScene& scene, const aiNode& node, const aiMatrix4x4& outer, Mesh& mesh) {
    const aiMatrix4x4 to_scene = outer * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        const aiMesh& part = *scene.mMeshes[node.mMeshes[i]];
        const std::size_t first = mesh.vertices.size();
        if (first + part.mNumVertices > std::numeric_limits<std::uint32_t>::max())
            throw Error("has over 4294967295 vertices, more than a mesh may have");
        for (unsigned k = 0; k < part.mNumVertices; ++k) {
            const aiVector3D at = to_scene * part.mVertices[k];
            mesh.vertices.push_back({at.x, at.y, at.z});
        }
        for (unsigned k = 0; k < part.mNumFaces; ++k) {
            const aiFace& face = part.mFaces[k];
            if (face.mNumIndices != 3) continue;
            auto& corners = mesh.triangles.emplace_back();
            for (std::size_t c = 0; c < 3; ++c)
                corners.at(c) = static_cast<std::uint32_t>(first + face.mIndices[c]);
        }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        append(scene, *node.mChildren[i], to_scene, mesh);
}

// In the other process, which ends soon: nothing is freed.
Mesh mesh_of(const aiScene* scene) {
    if (scene == nullptr) {
        const std::string why = Assimp::loaded().error();
        throw Error("assimp cannot read it: " +
                    (why == "std::bad_alloc" ? "it asks for too much memory" : why));
    }
    Mesh mesh;
    append(*scene, *scene->mRootNode, aiMatrix4x4(), mesh);
    if (mesh.triangles.empty()) throw Error("has no triangle: points and lines are no surface");
    return mesh;
}

void append_bytes(std::string& to, const void* from, std::size_t size) {
    to.append(static_cast<const char*>(from), size);
}

// What the other process writes: 'm', the numbers of vertices and triangles, and these; or 'e' and
// what is wrong.
std::string answer_of(const aiScene* scene) try {
    const Mesh mesh = mesh_of(scene);
    const std::array<std::size_t, 2> sizes{mesh.vertices.size(), mesh.triangles.size()};
    std::string answer = "m";
    append_bytes(answer, sizes.data(), sizeof sizes);
    append_bytes(answer, mesh.vertices.data(), mesh.vertices.size() * sizeof(Point3));
    append_bytes(answer, mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
    return answer;
} catch (const std::exception& error) {
    return std::string("e") + error.what();
}

// The process that imports, and the end of its pipe that is read. It ends with this object.
class Child {
public:
    template <class Import>
    Child(const std::string& name, rlim_t seconds, const Import& import) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) == 0) pid_ = ::fork();
        if (pid_ == 0) answer(ends[1], seconds, import);
        const std::string why = std::generic_category().message(errno);
        if (ends[1] != 0) ::close(ends[1]);
        pipe_ = ends[0];
        if (pid_ > 0) return;
        if (pipe_ != 0) ::close(pipe_);
        files::refuse(name, "no process for assimp: " + why);
    }
    ~Child() {
        ::kill(pid_, SIGKILL);
        while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
        ::close(pipe_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // All that it writes.
    std::string answer() const {
        constexpr int kMilliseconds = 20;  // between two questions whether to go on
        std::string all;
        std::array<char, 1U << 16U> part{};
        for (;;) {
            ask();
            pollfd ready{pipe_, POLLIN, 0};
            if (::poll(&ready, 1, kMilliseconds) == 0) continue;
            const ssize_t got = ::read(pipe_, part.data(), part.size());
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return all;
            all.append(part.data(), static_cast<std::size_t>(got));
        }
    }

private:
    template <class Import>
    [[noreturn]] static void answer(int pipe, rlim_t seconds, const Import& import) {
        const rlimit most{seconds, seconds};
        ::setrlimit(RLIMIT_CPU, &most);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which reserve terabytes
        const rlim_t half_of_memory = 2 * files::most_bytes();
        const rlimit most_data{half_of_memory, half_of_memory};
        ::setrlimit(RLIMIT_DATA, &most_data);
#endif
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0)
            ::dup2(nowhere, STDERR_FILENO);  // where assertions print
        const std::string all = answer_of(import());
        for (std::size_t sent = 0; sent < all.size();) {
            const ssize_t more = ::write(pipe, all.data() + sent, all.size() - sent);
            if (more < 0 && errno != EINTR) break;
            sent += static_cast<std::size_t>(std::max<ssize_t>(0, more));
        }
        ::_exit(0);
    }

    pid_t pid_ = -1;
    int pipe_ = -1;
};

template <class Import>
Mesh imported(const std::string& name, std::size_t bytes, const Import& import) {
    // Assimp reads over 1 MB in a second. After this processor time it is in a loop without end.
    const rlim_t most_seconds = 60 + bytes / 100000;
    std::string answer = Child(name, most_seconds, import).answer();
    if (answer.starts_with('e')) {
        std::replace(answer.begin(), answer.end(), '\n', ' ');
        files::refuse(name, answer.substr(1));
    }
    std::array<std::size_t, 2> sizes{};
    constexpr std::size_t kBegin = 1 + sizeof sizes;
    if (answer.size() >= kBegin) std::memcpy(sizes.data(), &answer[1], sizeof sizes);
    const std::size_t of_vertices = sizes[0] * sizeof(Point3);
    const std::size_t of_triangles = sizes[1] * sizeof(Mesh::triangles[0]);
    if (answer.size() != kBegin + of_vertices + of_triangles)
        files::refuse(name, "assimp cannot read it, and fails without a reason");
    Mesh mesh;
    mesh.vertices.resize(sizes[0]);
    mesh.triangles.resize(sizes[1]);
    std::memcpy(mesh.vertices.data(), &answer[kBegin], of_vertices);
    std::memcpy(mesh.triangles.data(), &answer[kBegin + of_vertices], of_triangles);
    return mesh;
}

const Assimp& assimp_for(const std::string& name) {
    const Assimp& assimp = Assimp::loaded();
    if (!assimp.missing().empty()) files::refuse(name, assimp.missing());
    return assimp;
}

// Assimp loops without end on a header that is cut, and its message about a file of points alone is
// unclear.
void check_header_of_ply(std::string_view bytes, const std::string& name) {
    files::ply::Rest rest{bytes, 0, name};
    const files::ply::Header header = files::ply::read_header(rest);
    for (const files::ply::Element& element : header.elements)
        if ((element.name == "face" || element.name == "tristrips") && element.count > 0) return;
    files::refuse(name, "has no element face: points alone are no surface");
}

constexpr unsigned kSteps = aiProcess_Triangulate;

}  // namespace

Mesh decode_mesh(std::string_view bytes, const std::string& name) {
    const std::string format = mesh_format_of(name);
    const Assimp& assimp = assimp_for(name);
    if (bytes.empty()) files::refuse(name, "is empty");
    if (bytes.size() > std::numeric_limits<unsigned>::max())
        files::refuse(name, "has over 4294967295 bytes, more than assimp reads");
    if (format == "ply") check_header_of_ply(bytes, name);
    return imported(name, bytes.size(), [&] {
        return assimp.import_bytes(bytes.data(), static_cast<unsigned>(bytes.size()), kSteps,
                                   format.c_str());
    });
}

Mesh read_mesh(const std::string& path) {
    const std::string format = mesh_format_of(path);
    const Assimp& assimp = assimp_for(path);
    const std::string bytes = files::read_whole(path);
    if (format != "gltf") return decode_mesh(bytes, path);
    // Its numbers may lie in a file beside it.
    return imported(path, bytes.size(), [&] { return assimp.import_file(path.c_str(), kSteps); });
}

}  // namespace lacuna

#else

namespace lacuna {

Mesh decode_mesh(std::string_view, const std::string& name) {
    files::refuse(name, fmt::format("a mesh, .{}: this program was built without assimp",
                                    mesh_format_of(name)));
}

Mesh read_mesh(const std::string& path) {
    return decode_mesh({}, path);
}

}  // namespace lacuna

#endif
