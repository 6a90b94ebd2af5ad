#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

// Where NULLSCOPE_CASE_TIMES names a file, one line a test case is added to it: processor seconds of all threads, file and name.
class CaseTimes : public doctest::IReporter {
public:
    explicit CaseTimes(const doctest::ContextOptions&) {
        if (const char* name = std::getenv("NULLSCOPE_CASE_TIMES"))
            file_ = std::fopen(name, "a");  // NOLINT(concurrency-mt-unsafe)
    }
    ~CaseTimes() override {
        if (file_ != nullptr) std::fclose(file_);
    }
    void test_case_start(const doctest::TestCaseData& data) override {
        name_ = data.m_name;
        file_of_it_ = data.m_file.c_str();
        started_ = std::clock();
    }
    void test_case_end(const doctest::CurrentTestCaseStats&) override {
        if (file_ == nullptr) return;
        std::fprintf(file_, "%.3f\t%s\t%s\n", static_cast<double>(std::clock() - started_) / CLOCKS_PER_SEC,
                     file_of_it_, name_);
        std::fflush(file_);
    }
    void report_query(const doctest::QueryData&) override {}
    void test_run_start() override {}
    void test_run_end(const doctest::TestRunStats&) override {}
    void test_case_reenter(const doctest::TestCaseData&) override {}
    void test_case_exception(const doctest::TestCaseException&) override {}
    void subcase_start(const doctest::SubcaseSignature&) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData&) override {}
    void log_message(const doctest::MessageData&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}

private:
    std::FILE* file_ = nullptr;
    const char *name_ = "", *file_of_it_ = "";
    std::clock_t started_ = 0;
};

REGISTER_LISTENER("case_times", 1, CaseTimes);

}  // namespace
