// A rocking block that chatters, as an engine for chattercheck: reads questions, one JSON object a line, and prints answers.
//
// Between impacts phi'' = phi - side - f(tau), with side the sign of phi and f = cos(omega tau) + r sin(omega tau) the acceleration of the ground
// over that which starts the rocking, r = sqrt(a^2 - 1). At an impact, phi = 0, the velocity is multiplied by eta. Replace what is yours.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

// cosh or sinh (sign = 1), cos or sin (sign = -1) from the power x^n on, divided by x^n: 1/n! + sign x^2/(n+2)! + ...
double series(int n, double x, double sign) {
    double total = 1 / std::tgamma(n + 1.0), term = total;
    while (std::abs(term) > 1e-17 * std::abs(total)) {
        n += 2;
        term *= sign * x * x / (n * (n - 1.0));
        total += term;
    }
    return total;
}

// side + f; 1 - cos is written as 2 sin^2, so that nothing is lost next to the start.
double pull(double side, double r, double phase) {
    const double c = std::cos(phase / 2), s = std::sin(phase / 2);
    return r * std::sin(phase) + (side > 0 ? 2 * c * c : -2 * s * s);
}

struct Landing {
    double interval, speed;
};

struct Flight {
    double side, v, omega, r, phase;

    // phi/s and phi' a time s after the impact. No term is the small difference of large ones, so that short flights are as right as long ones.
    std::pair<double, double> at(double s) const {
        const double w = omega, g = pull(side, r, phase);
        double h[5], b[5];
        for (int n = 0; n < 5; n++) {
            h[n] = series(n, s, 1);
            b[n] = h[n] + w * w * series(n, w * s, -1);
        }
        const double f = (std::cos(phase) + r * std::sin(phase)) * s * s * s * w * w / (1 + w * w);
        const double slope = (r * std::cos(phase) - std::sin(phase)) * s * s * w / (1 + w * w);
        return {v * h[1] - g * s * h[2] + f * b[4] - slope * b[3], v * h[0] - g * s * h[1] + f * b[3] - slope * b[2]};
    }

    // The first root of phi up to the time end: a scan for the change of sign, then Newton's method kept inside of the bracket.
    std::optional<Landing> landing(double end) const {
        const double g = pull(side, r, phase), step = v * g > 0 ? std::min(v / g / 2, end / 64) : end / 64;
        double low = 0, high = step;
        while (side * at(high).first > 0) {
            if (high >= end) return std::nullopt;
            low = high;
            high = std::min(high + std::max(step, high / 16), end);
        }
        double s = high, speed = 0;
        for (int n = 0; n < 200; n++) {
            const auto [phi, now] = at(s);
            speed = now;
            (side * phi > 0 ? low : high) = s;
            double next = s - phi * s / speed;
            if (!(low < next && next < high)) next = (low + high) / 2;
            if (std::abs(next - s) <= 2e-16 * s) break;
            s = next;
        }
        return Landing{s, speed};
    }
};

struct History {
    std::vector<double> time, interval, velocity;
    std::string ending = "never-rocks";
};

// The history of a case; until = 0 stands for half a period of the ground.
History chatter(double epsilon, double omega, double eta, std::size_t impacts, double until) {
    History history;
    const double r = std::sqrt(epsilon * (2 + epsilon)), end = until > 0 ? until : std::acos(-1.0) / omega;
    Flight flight{-1, 0, omega, r, 0};
    double now = 0, before = 0;
    while (epsilon > 0) {
        const auto landing = flight.landing(end - now);
        if (!landing || now + landing->interval >= end) {
            history.ending = until > 0 ? "limit-reached" : "incomplete";
            break;
        }
        const double interval = landing->interval;
        now += interval;
        flight = {-flight.side, eta * landing->speed, omega, r, omega * now};
        history.time.push_back(now);
        history.interval.push_back(interval);
        history.velocity.push_back(flight.v);
        if (std::abs(flight.v) < 1e-250 || history.time.size() == impacts) {
            // The intervals that are left are a geometric series; if the pull hardly changes while they last, the block comes to rest.
            const double left = (before + interval) * eta * eta / (1 - eta * eta);
            const double change = omega * left * std::abs(r * std::cos(omega * now) - std::sin(omega * now));
            const double weakest = std::min(pull(1, r, omega * now), -pull(-1, r, omega * now));
            history.ending = change < 0.1 * weakest ? "at-rest" : "limit-reached";
            break;
        }
        before = interval;
    }
    return history;
}

// With 17 significant digits, which are read back as the same double.
std::string list(const std::vector<double>& values) {
    std::string text = "[";
    for (const double value : values) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.17g", value);
        text += (text.size() > 1 ? "," : "") + std::string(digits);
    }
    return text + "]";
}

// The numbers behind "name": in a question, one or a list; none if it is something else. Questions have no spaces, and every name once.
std::vector<double> numbers(const std::string& question, const std::string& name) {
    std::vector<double> values;
    auto at = question.find("\"" + name + "\":");
    if (at == std::string::npos) return values;
    const char* rest = question.c_str() + at + name.size() + 3;
    do {
        char* after;
        const double value = std::strtod(rest + (*rest == '[' || *rest == ','), &after);
        if (after == rest) break;
        values.push_back(value);
        rest = after;
    } while (*rest == ',' && rest[1] != '"');
    return values;
}

std::string answer(const std::string& question) {
    const auto has = [&](const char* text) { return question.find(text) != std::string::npos; };
    const auto number = [&](const char* name) {
        const auto values = numbers(question, name);
        return values.empty() ? 0 : values[0];
    };
    if (has("\"cmd\":\"start\"")) {
        // The numbers are read and printed again, which shows that no digit is lost.
        return R"({"version":1,"engine":{"name":"my C++ engine","version":"1","language":"C++"},"models":["linear"],"normalisations":["threshold"],)"
               R"("ground":["sine"],"echo":)" + list(numbers(question, "echo")) + "}";
    }
    const auto seq = "{\"seq\":" + std::to_string(static_cast<long long>(number("seq"))) + ",";
    if (!has("\"model\":\"linear\"") || number("until") * number("omega") > 10) {
        return seq + R"("decline":{"reason":"not the linear block in little more than half a period"}})";
    }
    const auto impacts = static_cast<std::size_t>(number("impacts"));
    const auto history = chatter(number("epsilon"), number("omega"), number("eta"), impacts, number("until"));
    return seq + "\"history\":{\"time\":" + list(history.time) + ",\"interval\":" + list(history.interval) + ",\"velocity\":" +
           list(history.velocity) + ",\"ending\":\"" + history.ending + "\"}}";
}

int main() {
    for (std::string question; std::getline(std::cin, question) && question.find("\"cmd\":\"stop\"") == std::string::npos;) {
        // With std::endl, which flushes, or the gate waits for ever for an answer that stays in a buffer.
        std::cout << answer(question) << std::endl;
    }
}
