// Breaks files of every kind that plumb reads, and watches the readers.
//
//     fuzz_readers SECONDS [SEED [KIND]]
//
// Starts from good files of each kind, changes a few bytes, numbers or words, and hands the result
// to the reader in a child process. Whatever file it is, a reader has to return or to throw
// Error or MachineError. A crash, another exception, or 25 seconds without an answer is a
// finding: the file is kept in the folder fuzz_findings and named. Exit status 1 if there was
// any.
//
// What is read is looked at too: a scene that passes Validate is built for ray casting and one
// row of pixels is cast.
#include <OpenImageIO/imageio.h>
#include <assimp/scene.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "io/csv.h"
#include "io/height_map_file.h"
#include "io/histogram_io.h"
#include "io/image_io.h"
#include "io/mesh_io.h"
#include "io/picture_file.h"
#include "io/scene_file.h"
#include "rays/embree/embree_caster.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::string Get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void Put(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// A kind of file: what it is called, a good one, and how it is read.
struct Kind {
    std::string name, ending, good;
    std::function<void(const fs::path&)> read;
};

void LookAt(Scene scene) {
    scene.cameras = {{.position_m = {0.3, -4, 1}, .width_px = 32, .height_px = 1}};
    Validate(scene);
    const EmbreeCaster caster(scene);
    LookThrough(caster, scene, scene.cameras.front());
}

void ReadAsMesh(const fs::path& path) {
    MeshFile file = ReadMesh(path);
    Scene scene;
    scene.mesh = std::move(file.mesh);
    scene.material_of_face = std::move(file.material_of_face);
    scene.materials = std::move(file.materials);
    scene.textures = std::move(file.textures);
    LookAt(std::move(scene));
}

void ReadAsScene(const fs::path& path) {
    SceneFile file = ReadSceneFile(path);
    if (file.generator.empty() && file.heights.empty()) LookAt(std::move(file.scene));
}

constexpr const char* kObj =
    "mtllib square.mtl\nusemtl cloth\nv -1 0 0\nv 1 0 0\nv 1 0 2\nv -1 0 2\nvt 0 0\nvt 1 0\n"
    "vt 1 1\nvt 0 1\nvn 0 -1 0\nf 1/1/1 2/2/1 3/3/1 4/4/1\ng two\nf 1 2 3\nf -1 -2 -3\n";

constexpr const char* kScene = R"({"name": "all",
  "meshes": [{"file": "square.obj", "unit_m": 0.5, "up": "z", "alpha_tested": true},
             {"file": "square.obj", "textures": false}],
  "heights": [{"file": "make:bricks:16", "albedo": [0.5, 0.5, 0.5], "amplitude_m": 0.1, "tiles": 2}],
  "sky": [1, 2, 3], "environment": "sky.exr", "environment_turn_deg": 20,
  "directional_lights": [{"towards": [0, 0, 1], "irradiance": [1, 1, 1]}],
  "point_lights": [{"position_m": [0, 0, 1], "intensity": [1, 1, 1]}],
  "cameras": [{"name": "a", "position_m": [0, -3, 1], "target_m": [0, 0, 0], "up": [0, 0, 1],
               "fov_deg": 60, "width_px": 64, "height_px": 32}]})";

constexpr const char* kSide =
    R"({"name": "n", "spacing_m": 0.01, "amplitude_m": 0.1, "boundary": "wrap"})";

std::string EncodedPicture(const fs::path& folder, const std::string& ending, int channels,
                           OIIO::TypeDesc type) {
    const fs::path path = folder / ("seed." + ending);
    OIIO::ImageSpec spec(12, 9, channels, type);
    auto output = OIIO::ImageOutput::create(path.string());
    if (!output || !output->open(path.string(), spec)) return "";
    std::vector<float> values;
    for (int k = 0; k < 12 * 9 * channels; ++k) values.push_back(float(k % 17) / 17);
    output->write_image(OIIO::TypeDesc::FLOAT, values.data());
    output->close();
    return Get(path);
}

// Good files of every kind, with what they refer to beside them.
std::vector<Kind> Kinds(const fs::path& folder) {
    Put(folder / "square.obj", kObj);
    Put(folder / "square.mtl",
        "newmtl cloth\nKd 1 0.5 1\nd 0.5\nmap_Kd colours.png\nmap_d colours.png\n");
    Image<Rgb> colours(4, 4, Rgb{0.5f, 0.2f, 1});
    WritePreview(folder / "colours.png", colours);
    WriteExr(folder / "sky.exr", {{"R", Image<float>(4, 2, 1)},
                                  {"G", Image<float>(4, 2, 2)},
                                  {"B", Image<float>(4, 2, 3)}});
    std::vector<Kind> kinds;
    kinds.push_back({"scene", "json", kScene, ReadAsScene});
    kinds.push_back({"obj", "obj", kObj, ReadAsMesh});
    kinds.push_back({"off", "off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
                     ReadAsMesh});
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "square.obj").string(), 0);
    Assimp::Exporter exporter;
    for (std::size_t k = 0; scene != nullptr && k < exporter.GetExportFormatCount(); ++k) {
        const aiExportFormatDesc* format = exporter.GetExportFormatDescription(k);
        const std::string id = format->id, ending = format->fileExtension;
        if (id == "obj" || id == "objnomtl" || id == "assjson") continue;
        const fs::path path = folder / ("seed_" + id + "." + ending);
        if (exporter.Export(scene, id, path.string()) != aiReturn_SUCCESS) continue;
        kinds.push_back({id, ending, Get(path), ReadAsMesh});
    }
    const auto picture = [](const fs::path& path) { ReadPictureFile(path); };
    for (const char* ending : {"png", "jpg", "tga", "bmp", "tif", "gif"}) {
        for (const int channels : {3, 4}) {
            kinds.push_back(
                {std::string("picture_") + ending + std::to_string(channels), ending,
                 EncodedPicture(folder, ending, channels, OIIO::TypeDesc::UINT8), picture});
        }
    }
    for (const char* ending : {"exr", "hdr", "tif"}) {
        kinds.push_back({std::string("picture_float_") + ending, ending,
                         EncodedPicture(folder, ending, 3, OIIO::TypeDesc::FLOAT), picture});
    }
    const auto heights = [](const fs::path& path) { ReadHeightMap(path); };
    for (const char* ending : {"png", "tif", "exr"}) {
        kinds.push_back({std::string("heights_") + ending, ending,
                         EncodedPicture(folder, ending, 1,
                                        std::string(ending) == "exr" ? OIIO::TypeDesc::FLOAT
                                                                     : OIIO::TypeDesc::UINT16),
                         heights});
    }
    std::string pfm = "Pf\n3 2\n-1.0\n";
    pfm.append(24, '\0');
    kinds.push_back({"heights_pfm", "pfm", pfm, heights});
    kinds.push_back({"side_file", "json", kSide, [folder](const fs::path& path) {
                         const fs::path map = folder / "side.png";
                         WriteGreyPng(map, Image<double>(3, 3, 0.5), 8);
                         fs::copy_file(path, folder / "side.json",
                                       fs::copy_options::overwrite_existing);
                         ReadHeightMap(map);
                     }});
    BounceHistogram histogram;
    histogram.albedos = {0.5};
    for (int k = 0; k < 3; ++k) {
        BounceBin bin;
        bin.low = k / 3.0;
        bin.high = (k + 1) / 3.0;
        bin.count = 5;
        bin.alpha = (k + 0.5) / 3;
        bin.V = bin.alpha;
        bin.bounce.assign(3,
                          {.mean = 0.2, .variance = 0.01, .p05 = 0.1, .p50 = 0.2, .p95 = 0.3});
        bin.total.assign(1,
                         {.mean = 0.2, .variance = 0.01, .p05 = 0.1, .p50 = 0.2, .p95 = 0.3});
        histogram.bins.push_back(bin);
    }
    WriteHistogramCsv(folder / "seed.csv", histogram);
    WriteHistogramJson(folder / "seed.json", histogram);
    kinds.push_back({"histogram_csv", "csv", Get(folder / "seed.csv"),
                     [](const fs::path& path) { ReadCsv(path); }});
    kinds.push_back({"histogram_json", "json", Get(folder / "seed.json"),
                     [](const fs::path& path) { ReadHistogramJson(path); }});
    std::erase_if(kinds, [](const Kind& kind) { return kind.good.empty(); });
    return kinds;
}

class Mutator {
  public:
    explicit Mutator(std::uint64_t seed) : seed_(seed) {}

    std::string operator()(std::string bytes) {
        const int changes = 1 << Below(4);
        for (int k = 0; k < changes; ++k) Change(bytes);
        return bytes;
    }

  private:
    std::uint64_t Below(std::uint64_t n) { return RandomBits(seed_, count_++, 0, 0) % n; }

    void Change(std::string& bytes) {
        static const std::vector<std::string> kWords = {"nan",
                                                        "-1",
                                                        "0",
                                                        "1e39",
                                                        "-1e308",
                                                        "4294967295",
                                                        "2147483648",
                                                        "1e-46",
                                                        "inf",
                                                        "[",
                                                        "]",
                                                        "{",
                                                        "}",
                                                        "\"",
                                                        ",",
                                                        ":",
                                                        "null",
                                                        "true",
                                                        "\n",
                                                        " ",
                                                        "/",
                                                        "\\",
                                                        "%s",
                                                        std::string(300, '9'),
                                                        std::string(70, '['),
                                                        std::string(1, '\0'),
                                                        "../../gone"};
        static const std::vector<std::uint32_t> kNumbers = {
            0,           1,           0xffffffffu, 0x7fffffffu, 0x80000000u, 0xffffu,
            0x7f800000u, 0x7fc00000u, 0x10000u,    0x00ffffffu, 0xfffffffeu, 0x40000000u};
        if (bytes.empty()) bytes = " ";
        const std::size_t at = Below(bytes.size());
        switch (Below(9)) {
            case 0:
                bytes[at] = char(bytes[at] ^ (1 << Below(8)));
                break;
            case 1:
                bytes[at] = char(Below(256));
                break;
            case 2:
                bytes.erase(at, 1 + Below(8));
                break;
            case 3:
                bytes.insert(at, bytes.substr(Below(bytes.size()), 1 + Below(64)));
                break;
            case 4:
                bytes.insert(at, kWords[Below(kWords.size())]);
                break;
            case 5:
                ReplaceNumber(bytes, at, kWords[Below(9)]);
                break;
            case 6: {
                const std::uint32_t number = kNumbers[Below(kNumbers.size())];
                const std::size_t size = std::size_t{1} << Below(3);
                if (at + size <= bytes.size()) std::memcpy(&bytes[at], &number, size);
                break;
            }
            case 7:
                if (Below(4) == 0) bytes.resize(at);
                break;
            default:
                std::swap(bytes[at], bytes[Below(bytes.size())]);
        }
    }

    // The first run of digits after `at` by `word`.
    static void ReplaceNumber(std::string& bytes, std::size_t at, const std::string& word) {
        const std::size_t begin = bytes.find_first_of("0123456789", at);
        if (begin == std::string::npos) return;
        const std::size_t end = bytes.find_first_not_of("0123456789.eE+-", begin);
        bytes.replace(begin, (end == std::string::npos ? bytes.size() : end) - begin, word);
    }

    std::uint64_t seed_, count_ = 0;
};

constexpr int kBatch = 32;
// Longer than meshes may take by the reader's own limits (io/mesh_io.cpp), which end it first.
constexpr unsigned kPatienceS = 25;

std::string Case(const Kind& kind, std::uint64_t seed, std::uint64_t number) {
    return Mutator(Absorb(seed, number))(kind.good);
}

// Reads cases [first, last) one after the other; exits with 0 unless something is wrong.
[[noreturn]] void Child(const Kind& kind, const fs::path& path, std::uint64_t seed,
                        std::uint64_t first, std::uint64_t last) {
    std::freopen("/dev/null", "w", stdout);
    std::freopen("/dev/null", "w", stderr);
#ifndef __SANITIZE_ADDRESS__
    const rlimit memory{.rlim_cur = rlim_t{6} << 30, .rlim_max = rlim_t{6} << 30};
    setrlimit(RLIMIT_AS, &memory);
#endif
    for (std::uint64_t k = first; k < last; ++k) {
        Put(path, Case(kind, seed, k));
        alarm(kPatienceS);
        try {
            kind.read(path);
        } catch (const Error&) {
        } catch (const MachineError&) {
        } catch (const std::bad_alloc&) {
        } catch (...) {
            _exit(3);
        }
    }
    _exit(0);
}

// How the child ended: "" if well.
std::string Run(const Kind& kind, const fs::path& path, std::uint64_t seed, std::uint64_t first,
                std::uint64_t last) {
    const pid_t pid = fork();
    if (pid == 0) Child(kind, path, seed, first, last);
    int status = 0;
    waitpid(pid, &status, 0);
    if (WIFSIGNALED(status)) {
        return WTERMSIG(status) == SIGALRM ? "hangs"
                                           : "signal " + std::to_string(WTERMSIG(status));
    }
    return WEXITSTATUS(status) == 0   ? ""
           : WEXITSTATUS(status) == 3 ? "foreign exception"
                                      : "exit " + std::to_string(WEXITSTATUS(status));
}

int Fuzz(double seconds, std::uint64_t seed, const std::string& only) {
    const fs::path folder =
        fs::temp_directory_path() / ("plumb_fuzz_" + std::to_string(getpid()));
    const fs::path findings = "fuzz_findings";
    // Threads do not live on in a child: none may be started before.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    fs::create_directories(folder);
    std::vector<Kind> kinds = Kinds(folder);
    std::erase_if(kinds, [&](const Kind& kind) { return !only.empty() && kind.name != only; });
    std::map<std::string, std::int64_t> cases, found;
    const auto begin = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    for (std::uint64_t round = 0; elapsed() < seconds && !kinds.empty(); ++round) {
        for (const Kind& kind : kinds) {
            const fs::path path = folder / ("case." + kind.ending);
            const std::uint64_t first = round * kBatch;
            cases[kind.name] += kBatch;
            if (Run(kind, path, seed, first, first + kBatch).empty()) continue;
            for (std::uint64_t k = first; k < first + kBatch; ++k) {
                const std::string end = Run(kind, path, seed, k, k + 1);
                if (end.empty()) continue;
                fs::create_directories(findings);
                const std::string name = kind.name + "_" + std::to_string(seed) + "_" +
                                         std::to_string(k) + "." + kind.ending;
                if (++found[kind.name + ": " + end] <= 5) {
                    Put(findings / name, Case(kind, seed, k));
                    std::printf("%s: %s\n", name.c_str(), end.c_str());
                    std::fflush(stdout);
                }
            }
        }
    }
    fs::remove_all(folder);
    std::int64_t all = 0;
    for (const auto& [name, count] : cases) all += count;
    std::printf("%lld files of %zu kinds in %.0f s\n", static_cast<long long>(all),
                cases.size(), elapsed());
    for (const auto& [what, count] : found) {
        std::printf("  %s: %lld\n", what.c_str(), static_cast<long long>(count));
    }
    return found.empty() ? 0 : 1;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: fuzz_readers SECONDS [SEED [KIND]]\n");
        return 2;
    }
    return plumb::Fuzz(std::stod(argv[1]), argc > 2 ? std::stoull(argv[2]) : 1,
                       argc > 3 ? argv[3] : "");
}
