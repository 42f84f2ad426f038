// Texts that come in: lines as std::getline reads them, and the bounds.
#include "libltl/text/read_text.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <sstream>
#include <system_error>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::ltl {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  LineReader reader(in, "text");
  std::vector<std::string> out;
  for (std::string line; reader.next(line);) {
    out.push_back(line);
    EXPECT_EQ(reader.number(), out.size());
  }
  return out;
}

TEST(LineReader, ReadsWhatGetlineReads) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    std::string text;
    const std::size_t lines = random() % 6;
    for (std::size_t k = 0; k < lines; ++k) {
      // Around the size of a block, too.
      const std::size_t length = random() % 3 == 0 ? 4090 + random() % 10 : random() % 20;
      text += std::string(length, static_cast<char>('a' + random() % 3));
      if (k + 1 < lines || random() % 2 == 0) text += '\n';
    }
    std::istringstream in(text);
    std::vector<std::string> wanted;
    for (std::string line; std::getline(in, line);) wanted.push_back(line);
    ASSERT_EQ(lines_of(text), wanted) << "trial " << i;
  }
}

TEST(LineReader, DropsByteOrderMarksAndReturns) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a\r\n\r\nb\r"),
            (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(lines_of(std::string("a\0b\n", 4)), (std::vector<std::string>{std::string("a\0b", 3)}));
}

TEST(LineReader, StopsAtALineThatIsTooLong) {
  std::istringstream in("a\n" + std::string(most_line_bytes + 1, 'x') + "\nb\n");
  LineReader reader(in, "text");
  std::string line;
  EXPECT_TRUE(reader.next(line));
  try {
    reader.next(line);
    ADD_FAILURE() << "a line of any length";
  } catch (const FormatError& error) {
    EXPECT_EQ(error.line(), 2U) << error.what();
  }
  EXPECT_FALSE(reader.next(line));
}

TEST(ReadText, HasABound) {
  std::istringstream small(
      "\xEF\xBB\xBF"
      "abc"),
      large(std::string(11, 'x'));
  EXPECT_EQ(read_text(small, "small", 10), "abc");
  EXPECT_THROW(read_text(large, "large", 10), FormatError);
  EXPECT_THROW(read_text("/dev/zero", 1U << 20U), FormatError);
  EXPECT_THROW(read_text("."), FormatError);
  std::istringstream full(std::string(10, 'x'));
  EXPECT_EQ(read_text(full, "full", 10).size(), 10U);
}

// The bound is on what is read of a line, its end included.
TEST(LineReader, TakesALineAsLongAsTheBound) {
  const std::string line(most_line_bytes - 1, 'x');
  EXPECT_EQ(lines_of(line + "\nb"), (std::vector<std::string>{line, "b"}));
  EXPECT_EQ(lines_of("b\n" + line + "y"), (std::vector<std::string>{"b", line + "y"}));
  EXPECT_THROW(lines_of(line + "y\n"), FormatError);
}

// Breaks off after its text, as a disk does.
class Broken : public std::streambuf {
 public:
  explicit Broken(std::string text) : text_(std::move(text)) {}

 protected:
  int_type underflow() override {
    if (given_) throw std::runtime_error("no more");
    given_ = true;
    setg(text_.data(), text_.data(), text_.data() + text_.size());
    return traits_type::to_int_type(text_[0]);
  }

 private:
  std::string text_;
  bool given_ = false;
};

std::string message_of(const auto& reads) {
  try {
    reads();
  } catch (const FormatError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LineReader, NamesTheLineAtWhichItsSourceBreaks) {
  Broken source("a\nb\nc");
  std::istream in(&source);
  LineReader reader(in, "disk");
  std::string line;
  EXPECT_TRUE(reader.next(line) && reader.next(line));
  EXPECT_EQ(message_of([&] { reader.next(line); }), "cannot be read: the text may be cut here\n  disk:3");
  EXPECT_FALSE(reader.next(line));
  Broken again("abc");
  std::istream whole(&again);
  EXPECT_EQ(message_of([&] { read_text(whole, "disk"); }), "cannot be read to its end\n  disk");
}

class Folder {  // an empty one, removed at the end
 public:
  Folder() {
    std::string name = ::testing::TempDir() + "/waymark-XXXXXX";
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

TEST(OpenText, SaysWhyAFileCannotBeOpened) {
  const Folder folder;
  const auto refused = [](const std::filesystem::path& file) { return message_of([&] { open_text(file); }); };
  const auto because = [](int code, const std::filesystem::path& file) {
    return "cannot read the file: " + std::generic_category().message(code) + "\n  " + file.string();
  };
  std::ofstream(folder / "file") << "text";
  std::filesystem::create_symlink("loop", folder / "loop");
  const std::string long_name(300, 'n');
  EXPECT_EQ(refused(folder / "none"), because(ENOENT, folder / "none"));
  EXPECT_EQ(refused(folder / "file/below"), because(ENOTDIR, folder / "file/below"));
  EXPECT_EQ(refused(folder / "loop"), because(ELOOP, folder / "loop"));
  EXPECT_EQ(refused(folder / long_name.c_str()), because(ENAMETOOLONG, folder / long_name.c_str()));
  EXPECT_EQ(refused(folder / "."), "is a directory, not a file\n  " + (folder / ".").string());
  EXPECT_EQ(read_text(folder / "file"), "text");
}

TEST(OpenText, RefusesASocket) {
  const Folder folder;
  const std::string path = (folder / "socket").string();
  sockaddr_un name{};
  ASSERT_LT(path.size(), sizeof name.sun_path);
  name.sun_family = AF_UNIX;
  path.copy(name.sun_path, path.size());
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0) << path;
  EXPECT_EQ(message_of([&] { open_text(path); }), "is a socket, not a file\n  " + path);
  ::close(socket);
}

}  // namespace
}  // namespace waymark::ltl
