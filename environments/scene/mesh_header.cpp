#include "environments/scene/mesh_header.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "environments/scene/mesh_import.h"

namespace amble {
namespace {

// A STEP header is a few lines [bytes].
constexpr size_t kStepHeader = 65536;
// Extensions, or beginnings of their names, without which shapes and places are the same.
constexpr std::array<const char*, 6> kLooks = {"KHR_materials_",      "KHR_texture_",
                                               "EXT_texture_",        "MSFT_texture_dds",
                                               "KHR_lights_punctual", "KHR_xmp"};

std::string firstBytes(const std::filesystem::path& file, size_t count) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes(count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<size_t>(in.gcount()));
  return bytes;
}

// FILE_SCHEMA(('IFC2X3'));
void checkIfc(const std::filesystem::path& file) {
  const std::string header = firstBytes(file, kStepHeader);
  const size_t key = header.find("FILE_SCHEMA");
  const size_t begin = key == std::string::npos ? key : header.find('\'', key);
  const size_t end = begin == std::string::npos ? begin : header.find('\'', begin + 1);
  if (end == std::string::npos)
    throw InputError(file.string(), 0, "says no schema", "FILE_SCHEMA(('IFC2X3')) in its header");
  std::string schema = header.substr(begin + 1, std::min<size_t>(end - begin - 1, 40));
  for (char& c : schema) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (schema != "IFC2X3")
    throw InputError(file.string(), 0, "is of the schema " + schema, "IFC2X3: export it as that");
}

uint32_t numberAt(const std::string& bytes, size_t at) {
  std::array<unsigned char, 4> b;
  std::memcpy(b.data(), bytes.data() + at, b.size());
  return b[0] | b[1] << 8 | b[2] << 16 | static_cast<uint32_t>(b[3]) << 24;
}

// The JSON of a GLB: a header of three numbers (magic, version, length), then its first chunk:
// length, type, bytes.
std::string glbJson(const std::filesystem::path& file, size_t size) {
  constexpr size_t kHeader = 20;
  const std::string header = firstBytes(file, kHeader);
  if (header.size() < kHeader || !header.starts_with("glTF"))
    throw InputError(file.string(), 0, "is no GLB", "a file that begins with glTF and its lengths");
  const size_t length = numberAt(header, 12);
  if (numberAt(header, 8) > size || length > size - kHeader)
    throw InputError(
        file.string(), 0, "is shorter than its header says",
        std::to_string(std::max<size_t>(numberAt(header, 8), kHeader + length)) + " bytes");
  if (header.substr(16, 4) != "JSON")
    throw InputError(file.string(), 0, "is no GLB of glTF 2.0", "JSON as its first chunk");
  return firstBytes(file, kHeader + length).substr(kHeader);
}

void checkExtensions(const std::filesystem::path& file, const std::string& text) {
  using Json = nlohmann::json;
  // What is not asked for is not kept: buffers may be in the text.
  const auto wanted = [](int depth, Json::parse_event_t event, const Json& parsed) {
    return event != Json::parse_event_t::key || depth != 1 || parsed == "extensionsRequired";
  };
  const Json root = Json::parse(text, wanted, false);
  if (!root.is_object() || !root.contains("extensionsRequired")) return;
  for (const Json& entry : root["extensionsRequired"]) {
    const std::string name = entry.is_string() ? entry.get<std::string>() : entry.dump();
    const bool looks = std::any_of(kLooks.begin(), kLooks.end(),
                                   [&](const char* known) { return name.starts_with(known); });
    if (!looks)
      throw InputError(file.string(), 0, "requires the extension " + name + ", which is not known",
                       "a glTF exported without it");
  }
}

}  // namespace

void checkMeshHeader(const std::filesystem::path& file) {
  const std::string ending = meshEnding(file);
  const size_t size = std::filesystem::file_size(file);
  if (ending == ".ifc") checkIfc(file);
  if (ending == ".glb") checkExtensions(file, glbJson(file, size));
  if (ending == ".gltf") checkExtensions(file, firstBytes(file, size));
}

}  // namespace amble
