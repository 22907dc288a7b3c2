// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file fuzzReplay.cpp
  Takes the place of libFuzzer, whatever the compiler: runs a target on the files of a folder, and then on so many
  random inputs: replay-track corpus/track [count [seed]]. An input that ends the process was named before.
*/
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace {
using Input = std::vector<std::uint8_t>;

std::vector<Input> inputsOf(const std::filesystem::path &folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end()); // The same order everywhere.
  std::vector<Input> inputs;
  for (const std::filesystem::path &file : files) {
    std::ifstream stream(file, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return inputs;
}

//! One of the inputs with some bytes changed, left out or repeated, and a random end.
Input drawn(const std::vector<Input> &inputs, std::mt19937 &random)
{
  const auto below = [&random](std::size_t count) { return random() % std::max<std::size_t>(count, 1); };
  Input input = inputs[below(inputs.size())];
  for (std::size_t changes = 1 + below(16); changes > 0 && !input.empty(); --changes) {
    const std::size_t at = below(input.size());
    const std::size_t length = below(std::min<std::size_t>(input.size() - at, 64));
    const auto first = input.begin() + static_cast<std::ptrdiff_t>(at);
    const Input part(first, first + static_cast<std::ptrdiff_t>(length));
    switch (below(4)) {
    case 0:
      input.erase(first, first + static_cast<std::ptrdiff_t>(length));
      break;
    case 1:
      input.insert(first, part.begin(), part.end());
      break;
    default:
      input[at] = static_cast<std::uint8_t>(random());
    }
  }
  for (std::size_t more = below(2) * below(64); more > 0; --more) {
    input.push_back(static_cast<std::uint8_t>(random()));
  }
  return input;
}

//! \return Seconds that it took.
double run(const Input &input)
{
  const auto start = std::chrono::steady_clock::now();
  LLVMFuzzerTestOneInput(input.data(), input.size());
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void keep(const Input &input)
{
  std::ofstream stream("last-input", std::ios::binary);
  stream.write(reinterpret_cast<const char *>(input.data()), static_cast<std::streamsize>(input.size()));
}
} // namespace

int main(int argc, char *argv[])
{
  const std::vector<Input> inputs = argc > 1 ? inputsOf(argv[1]) : std::vector<Input>();
  if (inputs.empty()) {
    std::cerr << "Usage: " << argv[0] << " <folder of inputs> [<random inputs> [<seed>]]\n";
    return EXIT_FAILURE;
  }
  double longest = 0.;
  for (const Input &input : inputs) {
    longest = std::max(longest, run(input));
  }
  std::mt19937 random(argc > 3 ? static_cast<unsigned int>(std::stoul(argv[3])) : 1U);
  for (long left = argc > 2 ? std::stol(argv[2]) : 0; left > 0; --left) {
    const Input input = drawn(inputs, random);
    keep(input);
    const double seconds = run(input);
    if (seconds > longest) {
      longest = seconds;
      std::cout << left << " left, an input took " << seconds << " s" << std::endl;
    }
  }
  std::cout << inputs.size() << " inputs, the longest took " << longest << " s\n";
  return EXIT_SUCCESS;
}
