// A rectangle of pixels in memory. It knows nothing of files: io/ reads and writes them.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace plumb {

using Rgb = std::array<float, 3>;

/// Row-major pixels of type T; pixel (i, j) is column i of row j.
template <class T>
class Image {
  public:
    Image() = default;
    Image(int width, int height, const T& value = T{})
        : width_(width), height_(height), pixels_(std::size_t(width) * height, value) {
        assert(width >= 0 && height >= 0);
    }

    int Width() const { return width_; }
    int Height() const { return height_; }
    bool Empty() const { return pixels_.empty(); }

    T& operator()(int i, int j) { return pixels_[Index(i, j)]; }
    const T& operator()(int i, int j) const { return pixels_[Index(i, j)]; }

    std::vector<T>& Pixels() { return pixels_; }
    const std::vector<T>& Pixels() const { return pixels_; }

    friend bool operator==(const Image&, const Image&) = default;

  private:
    std::size_t Index(int i, int j) const {
        assert(0 <= i && i < width_ && 0 <= j && j < height_);
        return std::size_t(j) * width_ + i;
    }

    int width_ = 0, height_ = 0;
    std::vector<T> pixels_;
};

}  // namespace plumb
