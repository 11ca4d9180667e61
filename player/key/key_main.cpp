#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/cli/program.h"
#include "core/signing/trust_file.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante key make arm.key                     the secret arm.key, and arm.key.pub\n"
    "  rocinante key trust arm.key.pub --source arm >>trusted.toml\n"
    "  rocinante key trust relay.key.pub --source '*' --relay >>trusted.toml\n"
    "  rocinante source --demo arm --key arm.key\n"
    "  rocinante record --trust trusted.toml\n";

Result<cli::Exit> make(const std::string& path) {
  const SigningKey key = SigningKey::make();
  if (Status written = key.write(path); !written) return written.error();
  cli::say(
      fmt::format("key {}: keep {} secret, give {}.pub away\n", keyIdText(key.id()), path, path));
  return cli::Exit::done;
}

struct TrustArguments {
  std::string key;
  std::vector<std::string> sources;
  bool relay = false;
};

Result<cli::Exit> trust(const TrustArguments& arguments) {
  const Result<PublicKey> key = readPublicKey(arguments.key);
  if (!key) return key.error();
  if (arguments.sources.empty() && !arguments.relay) {
    return Error{ErrorKind::bad_argument,
                 "a key that may say nothing is of no use: give --source PATTERN or --relay", ""};
  }
  const std::string text = trustText({keyIdOf(*key), *key, arguments.sources, arguments.relay});
  // What is printed must be what --trust reads.
  if (const auto read = TrustFile::parse(text, "the trust file"); !read) {
    return Error{ErrorKind::bad_argument, read.error().what, "--source"};
  }
  cli::say(text);
  return cli::Exit::done;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app("Makes keys that sign datagrams, and entries of trust files (docs/signing.md).",
                   "rocinante-key");
  app.requireSubcommand();
  std::string made;
  const cli::CommandLine make_command = app.addSubcommand("make", "make a key pair");
  make_command.addOption("FILE", made, "the secret key's file; the public one is FILE.pub")
      .required();
  TrustArguments trusted;
  const cli::CommandLine trust_command =
      app.addSubcommand("trust", "print a public key's entry for a trust file");
  trust_command.addOption("FILE", trusted.key, "a key file, secret or public").required();
  trust_command
      .addOption("--source", trusted.sources,
                 "the SOURCEs that this key may send, as a pattern; repeatable")
      .oneEach()
      .valueText("PATTERN");
  trust_command.addFlag("--relay", trusted.relay,
                        "it may also restate for them (by=, via=) and answer subscribers");
  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    return make_command.isChosen() ? make(made) : trust(trusted);
  });
}
