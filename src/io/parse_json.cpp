#include "io/parse_json.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::io {
namespace {

class Builder final : public nlohmann::json_sax<ParsedJson> {
public:
    Builder(const LongList& list, JsonLimits limits) : list_{list}, limits_{limits} {}

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }  // JSON has none

    bool start_object(std::size_t) override { return open(ParsedJson::object()); }
    bool start_array(std::size_t) override { return open(ParsedJson::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& key) override {
        if (open_.back()->contains(key))
            base::refuse(fmt::format("expected each key once, found {} again", base::quote(key)));
        key_ = std::move(key);
        return true;
    }

    bool parse_error(std::size_t byte, const std::string&, const ParsedJson::exception& error) override {
        constexpr int numberOverflow = 406;
        if (error.id == numberOverflow)
            base::refuse(fmt::format("expected numbers that a double holds, found another at byte {}", byte));
        base::refuse(fmt::format("expected JSON, found something else at byte {}", byte));
    }

    ParsedJson take() { return std::move(whole_); }

private:
    // Where a value goes that begins or stands here.
    ParsedJson& next() {
        if (++values_ > limits_.values)
            base::refuse(fmt::format("expected at most {} values in {}, found more", limits_.values,
                                     longList_ == nullptr ? "the file" : fmt::format("one of {}", list_.key)));
        if (open_.empty()) return whole_;
        ParsedJson& parent = *open_.back();
        return parent.is_array() ? parent.emplace_back() : parent[key_];
    }

    template <class Value>
    bool add(Value&& value) {
        ParsedJson& added = next();
        added = std::forward<Value>(value);
        finish();
        return true;
    }

    bool open(ParsedJson&& empty) {
        if (open_.size() >= limits_.depth)
            base::refuse(fmt::format("expected at most {} lists and objects in each other, found more", limits_.depth));
        const bool isLong = open_.size() == 1 && empty.is_array() && open_.back()->is_object() && key_ == list_.key;
        ParsedJson& added = next();
        added = std::move(empty);
        open_.push_back(&added);
        if (isLong) {
            longList_ = &added;
            valuesOutside_ = std::exchange(values_, 0);
        }
        return true;
    }

    bool close() {
        if (open_.back() == longList_) {
            longList_ = nullptr;
            values_ = valuesOutside_;
        }
        open_.pop_back();
        finish();
        return true;
    }

    // A value has ended.
    void finish() {
        if (longList_ == nullptr || open_.back() != longList_) return;
        list_.take(longList_->back(), whole_);
        longList_->clear();
        values_ = 0;
    }

    const LongList& list_;
    JsonLimits limits_;
    ParsedJson whole_;
    std::vector<ParsedJson*> open_;   // lists and objects that have begun and not ended
    std::string key_;                 // of the value that comes next in an object
    ParsedJson* longList_ = nullptr;  // while it is open
    std::size_t values_ = 0;
    std::size_t valuesOutside_ = 0;
};

}  // namespace

ParsedJson parseJson(std::string_view text, const LongList& list, JsonLimits limits) {
    Builder builder{list, limits};
    if (!ParsedJson::sax_parse(text.begin(), text.end(), &builder)) base::refuse("expected JSON, found something else");
    return builder.take();
}

}  // namespace inkedge::io
