#include <dlfcn.h>
#include <link.h>

#include <cstring>
#include <filesystem>

#include "schedulers/module.h"

namespace raysweep {

namespace {

/// What dl_iterate_phdr is asked for: the object at `base`, and the linker's fingerprint in it.
struct Wanted {
  ElfW(Addr) base;
  std::string build_id;
};

/// The NT_GNU_BUILD_ID note of a segment of notes; empty if there is none.
std::string build_id_in(const char* notes, size_t size) {
  const auto padded = [](size_t n) { return (n + 3) / 4 * 4; };
  for (size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes + at, sizeof note);
    const size_t text = at + sizeof note + padded(note.n_namesz);
    const size_t name = at + sizeof note;
    const bool named = note.n_namesz == 4 && name + 4 <= size && std::memcmp(notes + name, "GNU", 4) == 0;
    if (named && note.n_type == NT_GNU_BUILD_ID && text + note.n_descsz <= size) {
      std::string id;
      for (size_t i = 0; i < note.n_descsz; ++i) {
        const auto byte = static_cast<unsigned char>(notes[text + i]);
        for (const int digit : {byte / 16, byte % 16}) id += "0123456789abcdef"[digit];
      }
      return id;
    }
    at = text + padded(note.n_descsz);
  }
  return {};
}

int look_at(dl_phdr_info* object, size_t, void* data) {
  auto& wanted = *static_cast<Wanted*>(data);
  if (object->dlpi_addr != wanted.base) return 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE || !wanted.build_id.empty()) continue;
    wanted.build_id =
        build_id_in(reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr), segment.p_memsz);
  }
  return 1;
}

}  // namespace

Library library_of(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || !info.dli_fname) return {};
  std::error_code error;
  const auto file =
      std::filesystem::canonical(info.dli_fname, error);  // links tell no version, names behind them do
  Wanted wanted{reinterpret_cast<ElfW(Addr)>(info.dli_fbase), {}};
  dl_iterate_phdr(look_at, &wanted);
  return {error ? info.dli_fname : file.string(), wanted.build_id};
}

}  // namespace raysweep
