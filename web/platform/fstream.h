// toml++ names file streams in functions that nobody calls here; libc++ for wasm32 only declares them. Included before every file.
#pragma once
#ifdef __cplusplus
#include <istream>
#include <streambuf>
#include <string>

_LIBCPP_BEGIN_NAMESPACE_STD

template <class Char, class Traits>
class basic_ifstream : public basic_istream<Char, Traits> {
public:
    template <class... Any>
    explicit basic_ifstream(const Any&...) : basic_istream<Char, Traits>(nullptr) {}
    template <class... Any>
    void open(const Any&...) {}
    bool is_open() const { return false; }
    void close() {}
};

_LIBCPP_END_NAMESPACE_STD
#endif
