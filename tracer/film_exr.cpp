#include "tracer/film_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTestFile.h>
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "tracer/settings.h"
#include "tracer/whole_file.h"

namespace raysweep {

namespace {

/// How threads are used is the schedulers' matter: none of the library's own.
constexpr int own_threads = 0;

constexpr std::array<const char*, 3> colours{"R", "G", "B"};
constexpr const char* id_channel = "id";

/// The library's stream to ours. It counts on exceptions.
class ExrStream : public Imf::OStream {
 public:
  explicit ExrStream(std::ostream& file) : OStream("picture"), file_(file) {}
  void write(const char bytes[], int count) override {
    if (!file_.write(bytes, count)) throw std::system_error(errno, std::generic_category());
  }
  uint64_t tellp() override { return static_cast<uint64_t>(file_.tellp()); }
  void seekp(uint64_t position) override { file_.seekp(static_cast<std::streamoff>(position)); }

 private:
  std::ostream& file_;
};

/// Where the channels of `film`, and of `ids` unless it is null, lie in memory. The library takes the same
/// type for reading and writing.
Imf::FrameBuffer frame_buffer(const Film& film, const uint32_t* ids, const Imath::Box2i& window) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  Imf::FrameBuffer buffer;
  const auto* const first = reinterpret_cast<const char*>(film.pixels().data());
  for (size_t i = 0; i < colours.size(); ++i)
    buffer.insert(colours[i], Imf::Slice::Make(Imf::FLOAT, first + i * sizeof(float), window, sizeof(Vec3f)));
  if (ids) buffer.insert(id_channel, Imf::Slice::Make(Imf::UINT, ids, window));
  return buffer;
}

/// Throws unless R, G and B are there at every pixel as floating-point numbers.
void check_channels(const Imf::ChannelList& channels, const std::string& path) {
  for (const char* name : colours) {
    const Imf::Channel* const channel = channels.findChannel(name);
    if (!channel || channel->type == Imf::UINT || channel->xSampling != 1 || channel->ySampling != 1) {
      throw std::runtime_error(fmt::format(
          "{}: has no channel {} of half or float at every pixel; R, G and B are needed", path, name));
    }
  }
}

ExrSize size_of(const Imath::Box2i& window, const std::string& path) {
  const long long width = 1LL + window.max.x - window.min.x, height = 1LL + window.max.y - window.min.y;
  if (!width_range.contains(width) || !height_range.contains(height)) {
    throw std::runtime_error(fmt::format("{}: {} × {} pixels are too large; at most {} × {} are possible",
                                         path, width, height, width_range.high, height_range.high));
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

void check_is_exr(const std::string& path) {
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
    throw std::runtime_error(fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
  if (!Imf::isOpenExrFile(path.c_str())) throw std::runtime_error(path + ": is not an EXR file");
}

/// Runs `step`, which uses the library; its exceptions say neither the file nor what to make of them.
template <class Step>
auto reading(const std::string& path, Step step) {
  try {
    return step();
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{}: is damaged or cut short, or an EXR file of a kind that is not read here: {}", path,
                    error.what()));
  }
}

}  // namespace

void write_exr(const Film& film, std::span<const uint32_t> hit_ids, const std::string& path) {
  if (!hit_ids.empty() && hit_ids.size() != film.pixels().size()) {
    throw std::invalid_argument(
        fmt::format("{}: {} hit ids for {} × {} pixels", path, hit_ids.size(), film.width(), film.height()));
  }
  Imf::Header header(film.width(), film.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* name : colours) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  if (!hit_ids.empty()) header.channels().insert(id_channel, Imf::Channel(Imf::UINT));
  write_whole_file(path, [&](std::ostream& file) {
    ExrStream stream(file);
    Imf::OutputFile out(stream, header, own_threads);
    out.setFrameBuffer(frame_buffer(film, hit_ids.empty() ? nullptr : hit_ids.data(), header.dataWindow()));
    out.writePixels(film.height());
  });
}

ExrSize exr_size(const std::string& path) {
  check_is_exr(path);
  const auto window =
      reading(path, [&] { return Imf::InputFile(path.c_str(), own_threads).header().dataWindow(); });
  return size_of(window, path);
}

ExrPicture read_exr(const std::string& path) {
  check_is_exr(path);
  std::optional<Imf::InputFile> file;
  reading(path, [&] { file.emplace(path.c_str(), own_threads); });
  if (!file->isComplete()) throw std::runtime_error(path + ": is cut short: scan lines are missing");
  const Imf::Header& header = file->header();
  check_channels(header.channels(), path);
  const ExrSize size = size_of(header.dataWindow(), path);
  ExrPicture picture{{size.width, size.height}, {}};
  const Imf::Channel* const id = header.channels().findChannel(id_channel);
  if (id && id->type == Imf::UINT) picture.hit_ids.resize(picture.film.pixels().size());
  reading(path, [&] {
    const uint32_t* const ids = picture.hit_ids.empty() ? nullptr : picture.hit_ids.data();
    file->setFrameBuffer(frame_buffer(picture.film, ids, header.dataWindow()));
    file->readPixels(header.dataWindow().min.y, header.dataWindow().max.y);
  });
  return picture;
}

}  // namespace raysweep
