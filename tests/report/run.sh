#!/usr/bin/env bash
# run.sh SOURCE WORK template|page [PROGRAM]: the tests of report/. Packages are installed into WORK by the lock file.
set -euo pipefail
source_folder="$1" work="$2" what="$3"

skip()
{
    echo "skipped: $1"
    exit 77
}

install_packages()
{
    command -v node >/dev/null || skip "node is not installed (Debian: nodejs)"
    command -v npm >/dev/null || skip "npm is not installed"
    mkdir -p -- "$work/report"
    cp -- "$source_folder/report/package.json" "$source_folder/report/package-lock.json" "$source_folder/report/.npmrc" \
        "$source_folder/report/build.mjs" "$work/report/"
    rm -rf -- "$work/report/src"
    cp -r -- "$source_folder/report/src" "$work/report/src"
    if ! cmp -s "$work/report/package-lock.json" "$work/report/installed.json"; then
        (cd -- "$work/report" && npm ci --no-audit --no-fund >npm.log 2>&1) || skip "npm ci failed: $(tail -n 1 "$work/report/npm.log")"
        cp -- "$work/report/package-lock.json" "$work/report/installed.json"
    fi
}

install_packages
case "$what" in
template)
    node "$work/report/build.mjs" "$work/report/page.html"
    cmp -- "$work/report/page.html" "$source_folder/report/page.html" || {
        echo "report/page.html is not what report/src gives: npm ci && npm run build"
        exit 1
    }
    ;;
page)
    command -v chromium >/dev/null || skip "chromium is not installed"
    export NODE_PATH="$work/report/node_modules"
    cp -- "$source_folder/tests/report/page_test.mjs" "$work/report/"
    node "$work/report/page_test.mjs" "$4" "$source_folder/testdata/headsq_ct.nrrd" "$work/page"
    ;;
esac
