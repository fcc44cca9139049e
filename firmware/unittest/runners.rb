# SPDX-License-Identifier: MIT
# Unity's generator for many files: runners.rb FOLDER TEST.c... writes FOLDER/TEST_runner.c, whose
# function is unittest_run. A runner that would be the same stays as it is, with its time.
require 'fileutils'
require 'generate_test_runner'

folder, *tests = ARGV
FileUtils.mkdir_p(folder)
tests.each do |test|
  runner = File.join(folder, "#{File.basename(test, '.c')}_runner.c")
  UnityTestRunnerGenerator.new(main_name: 'unittest_run').run(test, "#{runner}.new")
  if File.exist?(runner) && FileUtils.identical?(runner, "#{runner}.new")
    File.delete("#{runner}.new")
  else
    File.rename("#{runner}.new", runner)
  end
end
