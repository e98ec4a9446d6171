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
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <system_error>
#include <type_traits>

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

    const std::string& missing() const { return missing_; }  // empty if all were found

private:
    Assimp() {
        void* const library = ::dlopen("libassimp.so.5", RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) {
            missing_ =
                std::string("assimp cannot be loaded: ") + ::dlerror() + " (Debian: libassimp5)";
            return;
        }
        const auto find = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
                ::dlsym(library, name));
            if (function == nullptr && missing_.empty())
                missing_ = std::string("libassimp.so.5 lacks ") + name;
        };
        find(import_file, "aiImportFile");
        find(import_bytes, "aiImportFileFromMemory");
        find(error, "aiGetErrorString");
    }

    std::string missing_;
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
    if (scene == nullptr)
        throw Error(std::string("assimp cannot read it: ") + Assimp::loaded().error());
    Mesh mesh;
    append(*scene, *scene->mRootNode, aiMatrix4x4(), mesh);
    if (mesh.triangles.empty()) throw Error("has no triangle: points and lines are no surface");
    return mesh;
}

void send(int pipe, const void* from, std::size_t size) {
    const char* bytes = static_cast<const char*>(from);
    while (size > 0) {
        const ssize_t sent = ::write(pipe, bytes, size);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) ::_exit(1);
        bytes += sent;
        size -= static_cast<std::size_t>(sent);
    }
}

// Of processor time: assimp may be in a loop without end. A file of 1 GB takes minutes.
constexpr rlim_t kMostSeconds = 3600;

// Sends the numbers of vertices and triangles, and then these; or 0, 0 and what is wrong.
template <class Import>
[[noreturn]] void import_and_send(int pipe, const Import& import) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit seconds{kMostSeconds, kMostSeconds};
    ::setrlimit(RLIMIT_CPU, &seconds);
    if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0)
        ::dup2(nowhere, STDERR_FILENO);  // where assertions print
    Mesh mesh;
    std::string fault;
    try {
        mesh = mesh_of(import());
    } catch (const std::exception& error) {
        mesh = {};
        fault = error.what();
    }
    const std::array<std::uint64_t, 2> sizes{mesh.vertices.size(), mesh.triangles.size()};
    send(pipe, sizes.data(), sizeof sizes);
    send(pipe, mesh.vertices.data(), mesh.vertices.size() * sizeof(Point3));
    send(pipe, mesh.triangles.data(), mesh.triangles.size() * sizeof mesh.triangles[0]);
    send(pipe, fault.data(), fault.size());
    ::_exit(0);
}

// The process that imports, and the end of its pipe that is read. It ends with this object.
class Child {
public:
    template <class Import>
    explicit Child(const std::string& name, const Import& import) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(name);
        pid_ = ::fork();
        if (pid_ == 0) import_and_send(ends[1], import);
        const int error = errno;
        ::close(ends[1]);
        pipe_ = ends[0];
        if (pid_ > 0) return;
        ::close(pipe_);
        errno = error;
        fail(name);
    }
    ~Child() {
        ::kill(pid_, SIGKILL);
        while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
        ::close(pipe_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Reads up to `size` bytes; returns how many there were before the end.
    std::size_t receive(void* to, std::size_t size) const {
        constexpr int kMilliseconds = 20;  // between two questions whether to go on
        char* const bytes = static_cast<char*>(to);
        std::size_t got = 0;
        while (got < size) {
            ask();
            pollfd ready{pipe_, POLLIN, 0};
            if (::poll(&ready, 1, kMilliseconds) == 0) continue;
            const ssize_t more = ::read(pipe_, bytes + got, size - got);
            if (more < 0 && errno == EINTR) continue;
            if (more <= 0) break;
            got += static_cast<std::size_t>(more);
        }
        return got;
    }

private:
    [[noreturn]] static void fail(const std::string& name) {
        files::refuse(name, "no process for assimp: " + std::generic_category().message(errno));
    }

    pid_t pid_ = -1;
    int pipe_ = -1;
};

template <class Import>
Mesh imported(const std::string& name, const Import& import) {
    const Child child(name, import);
    std::array<std::uint64_t, 2> sizes{};
    Mesh mesh;
    const auto receive_all = [&](void* to, std::size_t size) {
        if (child.receive(to, size) != size)
            files::refuse(name, "assimp cannot read it, and fails without a reason");
    };
    receive_all(sizes.data(), sizeof sizes);
    if (sizes[1] == 0) {
        std::string why(1000, '\0');
        why.resize(child.receive(why.data(), why.size()));
        std::replace(why.begin(), why.end(), '\n', ' ');
        files::refuse(name, why);
    }
    mesh.vertices.resize(sizes[0]);
    mesh.triangles.resize(sizes[1]);
    receive_all(mesh.vertices.data(), sizes[0] * sizeof(Point3));
    receive_all(mesh.triangles.data(), sizes[1] * sizeof mesh.triangles[0]);
    return mesh;
}

const Assimp& assimp_for(const std::string& name) {
    const Assimp& assimp = Assimp::loaded();
    if (!assimp.missing().empty()) files::refuse(name, assimp.missing());
    return assimp;
}

// Assimp does not end where a header is cut, and has no words of its own for points.
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
    return imported(name, [&] {
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
    return imported(path, [&] { return assimp.import_file(path.c_str(), kSteps); });
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
