#include "io/output_file.h"

#include <unistd.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "geometry/error.h"

namespace toile {

namespace fs = std::filesystem;

namespace {

/// Where a path leads by symbolic links, also when no file is there yet.
fs::path followed(fs::path path) {
  constexpr int max_links = 40;  // as the kernel's
  std::error_code failed;
  for (int i = 0; i < max_links && fs::is_symlink(path, failed); ++i) {
    const fs::path target = fs::read_symlink(path, failed);
    path = path.parent_path() / target;
  }
  return path;
}

/// A file can be replaced by a finished one, what else there is can't.
void check_kind(const fs::path& path, const fs::path& target) {
  const fs::file_status status = fs::status(path);
  if (fs::is_directory(status)) throw Error(path.string(), "is a folder", "name a file");
  const bool is_stream = fs::weakly_canonical(path.parent_path()).string().starts_with("/proc/") ||
                         path.parent_path() == "/dev";
  if ((fs::exists(status) && !fs::is_regular_file(status)) || is_stream) {
    throw Error(path.string(), "is a device, a pipe or a socket", "name a file");
  }
  if (fs::exists(status) && access(target.c_str(), W_OK) != 0) {
    throw Error(path.string(), "may not be written", "name another file, or change its mode");
  }
}

/// Where a file is to be put in place. Nothing may be made beside what can't be replaced.
fs::path target_of(const fs::path& path) {
  fs::path target = followed(path);
  check_kind(path, target);
  return target;
}

}  // namespace

DescriptorBuffer::DescriptorBuffer(int descriptor)
    : descriptor_(descriptor), waiting_(std::size_t{1} << 16) {
  setp(waiting_.data(), waiting_.data() + waiting_.size());
}

bool DescriptorBuffer::write(const char* text, std::size_t size) const {
  while (size > 0) {
    const ssize_t written = ::write(descriptor_, text, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

int DescriptorBuffer::sync() {
  const bool done = write(pbase(), static_cast<std::size_t>(pptr() - pbase()));
  setp(waiting_.data(), waiting_.data() + waiting_.size());
  return done ? 0 : -1;
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c) {
  if (sync() != 0) return traits_type::eof();
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  return sputc(traits_type::to_char_type(c));
}

std::streamsize DescriptorBuffer::xsputn(const char* text, std::streamsize size) {
  if (size < epptr() - pptr()) return std::streambuf::xsputn(text, size);
  return sync() == 0 && write(text, static_cast<std::size_t>(size)) ? size : 0;
}

OutputFile::OutputFile(fs::path path)
    : path_(std::move(path)),
      target_(target_of(path_)),
      temporary_(target_),
      buffer_(temporary_.descriptor()),
      stream_(&buffer_) {
  if (!temporary_.is_open()) {
    throw Error(path_.string(), "can't be written",
                "check that its folder exists and that you may write there");
  }
}

void OutputFile::finish() {
  if (temporary_.is_open()) {
    stream_.flush();
    if (!temporary_.close()) stream_.setstate(std::ios::badbit);
  }
  if (!stream_) throw Error(path_.string(), "could not be written whole", "is the disk full?");
}

void OutputFile::commit() {
  finish();
  temporary_.put_in_place(target_);
}

void OutputFiles::add(const fs::path& path, std::string_view content) {
  files_.remove_if([&](const OutputFile& file) { return file.path() == path; });
  OutputFile& file = files_.emplace_back(path);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  file.finish();
}

const fs::path& OutputFiles::written(const fs::path& path) const {
  const auto file = std::ranges::find(files_, path, &OutputFile::path);
  if (file == files_.end()) throw Error(path.string(), "was not written", "");
  return file->temporary();
}

void OutputFiles::commit() {
  const SignalsWait wait;
  for (OutputFile& file : files_) file.commit();
  files_.clear();
}

void write_file(const OutputPath& path, std::string_view content) {
  OutputFiles alone;
  OutputFiles& files = path.files() != nullptr ? *path.files() : alone;
  files.add(path.path(), content);
  alone.commit();
}

void check_writable(const fs::path& path) { const OutputFile probe(path); }

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code absent;
  if (fs::equivalent(a, b, absent)) return true;
  const fs::path one = fs::weakly_canonical(fs::absolute(followed(a)));
  const fs::path other = fs::weakly_canonical(fs::absolute(followed(b)));
  return one.parent_path() == other.parent_path() &&
         boost::algorithm::iequals(one.filename().string(), other.filename().string());
}

void check_extension(const fs::path& path, const std::vector<std::string>& extensions) {
  for (const std::string& extension : extensions) {
    if (boost::algorithm::iequals(path.extension().string(), extension)) return;
  }
  const std::string& usual = extensions.front();
  throw Error(path.string(), "is not named " + usual + ", which is what would be written",
              "name it " + fs::path(path.filename()).replace_extension(usual).string());
}

std::string read_file(const fs::path& path) {
  std::error_code failed;
  if (fs::is_directory(path, failed)) throw Error(path.string(), "is a folder", "name a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(path.string(), "can't be read", "does the file exist?");
  // By blocks, for a pipe has no size. Byte by byte, it is a tenth of the start of a program.
  constexpr std::streamsize block = 1 << 18;
  constexpr std::uintmax_t max_reserved = 1 << 30;
  std::string content;
  const std::uintmax_t size = fs::file_size(path, failed);
  if (!failed && size < max_reserved) content.reserve(size + block);
  while (stream) {
    const std::size_t before = content.size();
    content.resize(before + block);
    stream.read(content.data() + before, block);
    content.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw Error(path.string(), "could not be read to its end", "");
  return content;
}

}  // namespace toile
