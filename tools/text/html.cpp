#include "text/html.h"

#include <fmt/format.h>

namespace hearth {

namespace {

// Colours are the reader's own: dark where the browser is dark.
constexpr std::string_view kHead = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{}</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ margin: 0 auto; max-width: 120rem; padding: 1rem 1.5rem; font: 1rem/1.5 system-ui, sans-serif; }}
h1, h2, h3, p {{ margin: 0 0 .5rem; overflow-wrap: anywhere; }}
figure {{ margin: 0; min-width: 0; }}
{}</style>
</head>
<body>
)html";

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  return html;
}

std::string pageBegin(std::string_view title, std::string_view style) {
  return fmt::format(kHead, escaped(title), style);
}

}  // namespace hearth
